#include "names.h"

#include "resolve.h"

#include <heed/owl/vocabulary.h>

#include <fmt/format.h>

namespace heed::owl {

namespace v = vocabulary;

Names::Names(const util::SourceText& source, const ReadContext& context)
    : source_(source), context_(context), base_("file:" + source.name()) {
  prefixes_ = {{"rdf", HEED_RDF}, {"rdfs", HEED_RDFS}, {"xsd", HEED_XSD}, {"owl", HEED_OWL}};
}

void Names::declare_prefix(std::string_view prefix, std::string_view uri) {
  prefixes_.insert_or_assign(std::string(prefix), std::string(uri));
}

Iri Names::prefixed(std::string_view prefix, std::string_view local, std::size_t offset) {
  const auto found = prefixes_.find(prefix);
  if (found == prefixes_.end()) {
    std::vector<std::string> known;
    for (const auto& entry : prefixes_) known.push_back(entry.first + ":");
    fail(offset, "undeclared-prefix", fmt::format("prefix '{}:' is not declared", prefix),
         util::suggestion(std::string(prefix) + ":", known));
  }
  scratch_.assign(found->second).append(local);
  return checked(offset);
}

Iri Names::abbreviated(std::string_view name, std::size_t offset) {
  const std::size_t colon = name.find(':');
  if (colon == std::string_view::npos) return prefixed({}, name, offset);
  return prefixed(name.substr(0, colon), name.substr(colon + 1), offset);
}

Iri Names::resolved(std::string_view base, std::string_view reference, std::size_t offset) {
  resolve_iri(base, reference, scratch_);
  return checked(offset);
}

Iri Names::checked(std::size_t offset) {
  const std::size_t count = context_.iris.size();
  const Iri iri = context_.iris.intern(scratch_);
  const std::size_t bad = context_.iris.size() > count ? first_bad_character(scratch_) : std::string::npos;
  if (bad != std::string::npos)
    warn(offset, "bad-iri", fmt::format("'{}' is no IRI: it holds '{}'", scratch_, scratch_[bad]),
         "write such a character as %20 and the like");
  return iri;
}

Iri Names::anonymous(std::string_view label) {
  const auto found = anonymous_.find(label);
  if (found != anonymous_.end()) return found->second;
  const Iri iri = context_.iris.intern(fmt::format("_:d{}b{}", context_.document, anonymous_.size()));
  anonymous_.emplace(std::string(label), iri);
  return iri;
}

Literal Names::literal(std::string value, Iri datatype, std::string_view language) {
  Literal out{std::move(value), datatype, std::string(language)};
  if (datatype == v::rdf_plain_literal && language.empty()) {
    const std::size_t at = out.value.rfind('@');
    if (at != std::string::npos &&
        (at + 1 == out.value.size() || is_language_tag(out.value.substr(at + 1)))) {
      out.language = out.value.substr(at + 1);
      out.value.resize(at);
    }
    out.datatype = v::xsd_string;
  }
  for (char& c : out.language)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  if (!out.language.empty()) out.datatype = v::rdf_lang_string;
  return out;
}

void Names::warn(std::size_t offset, const char* code, std::string message, std::string hint) {
  context_.diagnostics.push_back(warning_at(source_, offset, code, std::move(message), std::move(hint)));
}

void Names::fail(std::size_t offset, const char* code, std::string message, std::string hint) const {
  throw util::InputError(source_, offset, code, std::move(message), std::move(hint));
}

}  // namespace heed::owl
