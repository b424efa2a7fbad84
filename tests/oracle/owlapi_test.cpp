// What the OWL API writes in its five syntaxes are the same axioms to heed, and the OWL API reads what heed
// writes. Convert.java is the other side.
#include "axioms.h"
#include "temporary_folder.h"

#include <heed/owl/write.h>

#include <fmt/format.h>

#include <cstdlib>
#include <iostream>

namespace heed::owl::test {
namespace {

const std::string jars = "/usr/share/java";

bool installed() {
  return std::filesystem::exists(jars + "/owlapi-apibinding.jar") &&
         std::system("command -v java >/dev/null 2>&1") == 0;
}

/// A folder of its own for every test.
class OwlApi : public testing::Test {
 protected:
  void SetUp() override {
    if (!installed()) GTEST_SKIP() << "no OWL API (Debian: libowlapi-java, default-jdk-headless)";
  }

  /// Converts all of \p files in one run of Java.
  void convert(const std::vector<std::string>& files) const {
    std::string command = fmt::format("java -cp '{0}/*' '{1}/tests/oracle/Convert.java' '{2}'", jars,
                                      HEED_SOURCE_DIR, folder_.path());
    for (const std::string& file : files) command += fmt::format(" '{}'", file);
    command += fmt::format(" 2>'{}'", folder_.path("messages"));
    if (std::system(command.c_str()) != 0)
      ADD_FAILURE() << util::read_file(folder_.path("messages")).text().substr(0, 2000);
  }

  [[nodiscard]] std::string converted(const std::string& file, const std::string& extension) const {
    return folder_.path(std::filesystem::path(file).filename().string() + "." + extension);
  }

  heed::test::TemporaryFolder folder_;
};

/// Two names that are inverse to each other may stand in either order.
std::string either_way(const std::string& axiom) {
  constexpr std::string_view head = "InverseObjectProperties(";
  const std::size_t space = axiom.find(' ');
  if (!axiom.starts_with(head) || axiom.find(' ', space + 1) + 2 != axiom.size()) return axiom;
  const std::string first = axiom.substr(head.size(), space - head.size());
  const std::string second = axiom.substr(space + 1, axiom.size() - space - 3);
  return first < second ? axiom : fmt::format("{}{} {} )", head, second, first);
}

/// Logical axioms once each. The OWL API takes `x a owl:Thing` for a declaration, and writes no inclusion of
/// a complex class in the Manchester syntax, which has no frame for it.
std::set<std::string> comparable(const Ontology& ontology, bool manchester) {
  std::set<std::string> out;
  for (const std::string& axiom : logical(ontology)) {
    const bool trivial = axiom.starts_with("ClassAssertion(<http://www.w3.org/2002/07/owl#Thing>");
    const bool general = axiom.starts_with("SubClassOf(Object") || axiom.starts_with("SubClassOf(Data");
    if (!trivial && !(general && manchester)) out.insert(either_way(axiom));
  }
  return out;
}

/// The same axioms; at most a few of the difference are shown.
void expect_same(const Ontology& wanted, const Ontology& got, const std::string& what) {
  const bool manchester = what.ends_with("omn");
  const auto a = comparable(wanted, manchester), b = comparable(got, manchester);
  std::vector<std::string> lost, invented;
  std::set_difference(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(lost));
  std::set_difference(b.begin(), b.end(), a.begin(), a.end(), std::back_inserter(invented));
  for (std::size_t i = 0; i < lost.size() && i < 5; ++i) ADD_FAILURE() << what << " lost " << lost[i];
  for (std::size_t i = 0; i < invented.size() && i < 5; ++i)
    ADD_FAILURE() << what << " invented " << invented[i];
}

std::vector<std::string> inputs() {
  std::vector<std::string> out{std::string(HEED_SOURCE_DIR) + "/tests/oracle/every_axiom.ofn"};
  for (const char* file : {"signs/signs.ofn", "public/pizza.owl", "public/sio.owl"})
    if (std::filesystem::exists(corpus() + "/owl/" + file)) out.push_back(corpus() + "/owl/" + file);
  return out;
}

TEST_F(OwlApi, FiveSyntaxesAreTheSameAxioms) {
  const auto files = inputs();
  convert(files);
  for (const std::string& file : files) {
    const Ontology wanted = read_path(file);
    for (const char* extension : {"owl", "ttl", "owx", "ofn", "omn"})
      expect_same(wanted, read_path(converted(file, extension)), file + " as " + extension);
  }
  std::cout << files.size() << " ontologies, " << 5 * files.size() << " documents compared\n";
}

TEST_F(OwlApi, ReadsWhatIsWritten) {
  const auto files = inputs();
  std::vector<std::string> written;
  for (std::size_t i = 0; i < files.size(); ++i) {
    const Ontology ontology = read_path(files[i]);
    written.push_back(folder_.path(fmt::format("{}.functional.ofn", i)));
    util::write_file(written.back(), write_functional(ontology));
    written.push_back(folder_.path(fmt::format("{}.turtle.ttl", i)));
    util::write_file(written.back(), write_turtle(ontology));
  }
  convert(written);
  for (std::size_t i = 0; i < written.size(); ++i)
    expect_same(read_path(files[i / 2]), read_path(converted(written[i], "ofn")), written[i]);
}

}  // namespace
}  // namespace heed::owl::test
