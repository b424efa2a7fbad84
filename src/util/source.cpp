#include <heed/util/source.h>

#include <algorithm>

namespace heed::util {

std::string to_string(const Location& location) {
  std::string out(location.file_name());
  if (location.line == 0) return out;
  if (!out.empty()) out += ':';
  out += std::to_string(location.line);
  if (location.column != 0) out += ':' + std::to_string(location.column);
  return out;
}

SourceText::SourceText(std::string name, std::string text, std::uint32_t first_line,
                       std::uint32_t first_column) {
  auto data = std::make_shared<Data>();
  data->name = std::make_shared<const std::string>(std::move(name));
  data->text = std::move(text);
  data->first_line = first_line;
  data->first_column = first_column;
  data->line_starts.push_back(0);
  for (std::size_t i = 0; i < data->text.size(); ++i)
    if (data->text[i] == '\n') data->line_starts.push_back(i + 1);
  data_ = std::move(data);
}

Location SourceText::at(std::size_t offset) const {
  const auto& starts = data_->line_starts;
  const auto next = std::upper_bound(starts.begin(), starts.end(), offset);
  const auto index = static_cast<std::size_t>(next - starts.begin()) - 1;
  auto column = static_cast<std::uint32_t>(offset - starts[index] + 1);
  if (index == 0) column += data_->first_column - 1;
  return {data_->name, data_->first_line + static_cast<std::uint32_t>(index), column};
}

std::string_view SourceText::line_of(std::size_t offset) const {
  const auto& starts = data_->line_starts;
  const auto next = std::upper_bound(starts.begin(), starts.end(), offset);
  const std::size_t begin = *(next - 1);
  std::size_t end = data_->text.find('\n', begin);
  if (end == std::string::npos) end = data_->text.size();
  if (end > begin && data_->text[end - 1] == '\r') --end;
  return std::string_view(data_->text).substr(begin, end - begin);
}

}  // namespace heed::util
