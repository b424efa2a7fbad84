#pragma once

#include <heed/spec/dialect.h>
#include <heed/strategy/synthesize.h>

#include <string>

namespace heed::dialects {

/// "R", "U", or "?" when \p seconds did not suffice.
inline std::string verdict(const spec::Gr1& spec, double seconds) {
  util::Limits limits;
  limits.seconds = seconds;
  util::Budget budget(limits);
  strategy::Options options;
  options.only_realizability = true;
  try {
    return strategy::synthesize(spec, budget, options).realizable ? "R" : "U";
  } catch (const util::LimitExceeded&) {
    return "?";
  }
}

inline constexpr spec::Dialect all_dialects[] = {spec::Dialect::Slugsin, spec::Dialect::StructuredSlugs,
                                                 spec::Dialect::Gr1c, spec::Dialect::Gr1};

/// \p spec written in \p dialect and read again.
inline spec::Gr1 again(const spec::Gr1& spec, spec::Dialect dialect) {
  constexpr const char* names[] = {"again.gr1", "again.slugsin", "again.structuredslugs", "again.spc"};
  return spec::read_any(util::SourceText(names[static_cast<int>(dialect)], spec::write_as(spec, dialect)));
}

}  // namespace heed::dialects
