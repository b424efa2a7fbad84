#include <heed/export/exec.h>
#include <heed/export/runner.h>
#include <heed/util/diagnostic.h>

#include <fmt/format.h>

#include <istream>
#include <iterator>
#include <optional>
#include <ostream>

#include "observation.h"
#include "reaction.h"

namespace heed::exporter {
namespace {

struct Fault {
  std::string error, hint;
};

/// What the user can do about a missing row: the assumptions, as many as a line bears.
std::string missing_row_hint(const std::vector<std::string>& assumptions) {
  constexpr std::size_t most = 3;
  if (assumptions.empty()) return "what it was synthesized from does not allow this observation now";
  std::string hint = "the controller relies on: ";
  for (std::size_t i = 0; i < std::min(most, assumptions.size()); ++i)
    hint += (i == 0 ? "" : "; ") + assumptions[i];
  if (assumptions.size() > most) hint += fmt::format("; and {} more", assumptions.size() - most);
  return hint;
}

/// A controller, however it is written down, one step after the other.
class Steps {
 public:
  Steps() = default;
  Steps(const Steps&) = delete;
  Steps& operator=(const Steps&) = delete;
  virtual ~Steps() = default;
  [[nodiscard]] virtual bool answers(const model::Valuation& observation) const = 0;
  /// \returns whether the answer is a fallback. \pre answers(observation)
  virtual bool take(const model::Valuation& observation) = 0;
  /// The columns of the last step; nullptr before the first.
  [[nodiscard]] virtual const model::Valuation* reaction() const = 0;
  [[nodiscard]] virtual const std::vector<std::string>& assumptions() const = 0;
  virtual void reset() = 0;
};

class ListedSteps final : public Steps {
 public:
  explicit ListedSteps(model::Mealy machine) : runner_(checked(std::move(machine))) {}
  [[nodiscard]] bool answers(const model::Valuation& observation) const override {
    const std::optional<std::uint32_t> letter = runner_.letter(observation);
    return letter && runner_.answers(*letter);
  }
  bool take(const model::Valuation& observation) override {
    const Runner::Answer answer = runner_.step_letter(*runner_.letter(observation));
    reaction_ = &runner_.machine().output_letters[answer.output];
    return answer.status == Status::Fallback;
  }
  [[nodiscard]] const model::Valuation* reaction() const override { return reaction_; }
  [[nodiscard]] const std::vector<std::string>& assumptions() const override {
    return runner_.machine().assumptions;
  }
  void reset() override {
    runner_.reset();
    reaction_ = nullptr;
  }

 private:
  static model::Mealy checked(model::Mealy machine) {
    if (machine.state_count() == 0)
      throw util::InputError({}, "no-states", "the controller has no states", "");
    return machine;
  }
  Runner runner_;
  const model::Valuation* reaction_ = nullptr;  ///< In the machine.
};

class SymbolicSteps final : public Steps {
 public:
  explicit SymbolicSteps(SymbolicRunner runner) : runner_(std::move(runner)) {}
  [[nodiscard]] bool answers(const model::Valuation& observation) const override {
    return runner_.answers(observation);
  }
  bool take(const model::Valuation& observation) override {
    reaction_ = runner_.step(observation);
    return false;
  }
  [[nodiscard]] const model::Valuation* reaction() const override {
    return reaction_ ? &*reaction_ : nullptr;
  }
  [[nodiscard]] const std::vector<std::string>& assumptions() const override {
    return runner_.controller().assumptions;
  }
  void reset() override {
    runner_.reset();
    reaction_.reset();
  }

 private:
  SymbolicRunner runner_;
  std::optional<model::Valuation> reaction_;
};

/// All columns of a symbolic controller, in their order.
std::vector<model::Output> columns(const model::SymbolicController& controller) {
  std::vector<model::Output> all = controller.outputs;
  all.insert(all.end(), controller.memories.begin(), controller.memories.end());
  all.insert(all.end(), controller.definitions.begin(), controller.definitions.end());
  return all;
}

}  // namespace

class LineExecutor::Impl {
 public:
  explicit Impl(model::Mealy machine)
      : reader_(machine.inputs),
        writer_(machine.outputs),
        steps_(std::make_unique<ListedSteps>(std::move(machine))) {}
  explicit Impl(SymbolicRunner runner)
      : reader_(runner.controller().inputs),
        writer_(columns(runner.controller())),
        steps_(std::make_unique<SymbolicSteps>(std::move(runner))) {}

  std::string line(std::string_view json) {
    if (json.size() > max_line)
      return answer_fault({fmt::format("the line is longer than {} bytes", max_line),
                           "send one observation a line; a line ends with a line feed"});
    LineReading reading = reader_.read(json);
    if (reading.kind == LineReading::Kind::Reset) return reset();
    if (reading.kind == LineReading::Kind::Error)
      return answer_fault({std::move(reading.error), std::move(reading.hint)});
    if (!steps_->answers(reading.observation))
      return answer_fault({"no row for this observation: the controller does not know what to do here",
                           missing_row_hint(steps_->assumptions())});
    const bool fallback = steps_->take(reading.observation);
    if (!fallback) legal_ = std::move(reading.observation);
    std::string out = head();
    return close(out, fallback ? "the observation breaks an assumption" : nullptr);
  }

 private:
  std::string reset() {
    steps_->reset();
    step_ = 0;
    legal_.reset();
    return "{\"reset\": true}";
  }

  std::string answer_fault(const Fault& fault) {
    const char* note =
        steps_->reaction() != nullptr ? "the last reaction is repeated" : "there is no reaction yet";
    if (legal_ && steps_->answers(*legal_)) {
      steps_->take(*legal_);
      note = "answered as the last legal observation would be";
    }
    std::string out = head();
    out += ", \"error\": " + json_quoted(fault.error) + ", \"hint\": " + json_quoted(fault.hint);
    return close(out, note);
  }

  std::string head() { return fmt::format("{{\"step\": {}", step_++); }

  /// \param note  Which fallback this is; nullptr: none.
  std::string close(std::string& out, const char* note) const {
    writer_.append(out, steps_->reaction());
    out += ", \"fallback\": ";
    out += note != nullptr ? "true, \"note\": \"" : "false";
    if (note != nullptr) (out += note) += '"';
    out += '}';
    return std::move(out);
  }

  ObservationReader reader_;
  ReactionWriter writer_;
  std::unique_ptr<Steps> steps_;
  std::uint64_t step_ = 0;
  std::optional<model::Valuation> legal_;  ///< The last observation that a row not marked as fallback took.
};

LineExecutor::LineExecutor(model::Mealy machine) : impl_(std::make_unique<Impl>(std::move(machine))) {}
LineExecutor::LineExecutor(SymbolicRunner runner) : impl_(std::make_unique<Impl>(std::move(runner))) {}
LineExecutor::~LineExecutor() = default;
LineExecutor::LineExecutor(LineExecutor&&) noexcept = default;
LineExecutor& LineExecutor::operator=(LineExecutor&&) noexcept = default;

std::string LineExecutor::line(std::string_view json) {
  return impl_->line(json);
}

void LineExecutor::run(std::istream& in, std::ostream& out) {
  constexpr int end = std::char_traits<char>::eof();
  std::streambuf& source = *in.rdbuf();
  std::string text;
  for (int c = source.sbumpc(); c != end && out; c = source.sbumpc()) {
    text.clear();
    for (; c != end && c != '\n' && text.size() <= max_line; c = source.sbumpc())
      text += static_cast<char>(c);
    out << line(text) << '\n';
    const bool cut = c != end && c != '\n';
    if (cut || source.in_avail() <= 0) out.flush();
    while (c != end && c != '\n') c = source.sbumpc();
    if (c == end) break;
  }
  out.flush();
}

}  // namespace heed::exporter
