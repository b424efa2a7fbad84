// Any bytes as an ontology document: read, written and read again without a crash, whatever they are. What is
// refused must be refused by InputError. HEED_FUZZ_READER only chooses how the document is introduced, so
// that each reader gets its share of the time.

#include <heed/owl/print.h>
#include <heed/owl/read.h>
#include <heed/owl/write.h>

#include <cstdlib>
#include <iostream>

namespace {

using namespace heed;

std::string name_of_document() {
  const std::string_view reader = HEED_FUZZ_READER;
  if (reader == "turtle") return "fuzz.ttl";
  if (reader == "owlxml") return "fuzz.owx";
  if (reader == "functional") return "fuzz.ofn";
  if (reader == "manchester") return "fuzz.omn";
  return "fuzz.owl";
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  util::Limits limits;
  limits.nesting = 500;
  limits.entity_bytes = 1 << 16;
  util::Diagnostics diagnostics;
  owl::Ontology ontology;
  try {
    const util::SourceText source(name_of_document(), std::string(reinterpret_cast<const char*>(data), size));
    ontology = owl::read(source, limits, diagnostics);
  } catch (const util::InputError&) {
    return 0;
  }
  for (const owl::Axiom& axiom : ontology.axioms()) (void)owl::to_text(axiom, ontology);
  const std::string written = owl::write_functional(ontology);
  try {
    limits.nesting = 0;
    const owl::Ontology again = owl::read(util::SourceText("again.ofn", written), limits, diagnostics);
    if (again.axioms().size() == ontology.axioms().size()) return 0;
  } catch (const util::InputError& error) {
    std::cerr << error.what() << '\n';
    // An IRI of RDF may hold what no syntax of OWL can write; it was warned of.
    for (const util::Diagnostic& d : diagnostics)
      if (d.code == "bad-iri") return 0;
  }
  std::cerr << "what was written does not read back:\n" << written;
  std::abort();
}
