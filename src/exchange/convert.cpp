#include "exchange/convert.hpp"

#include "exchange/exchange_set.hpp"
#include "foramen/core/error.hpp"

namespace foramen {
namespace {

struct Ending {
  ExchangeFormat format;
  const char* text;  ///< ending of the file name, by which readers recognise the format
};

// If several formats have the same ending, the first one is the default.
constexpr Ending endings[] = {
    {ExchangeFormat::scalismo_json, ".json"}, {ExchangeFormat::statismo, ".h5"},
    {ExchangeFormat::shapeworks, ".swproj"},  {ExchangeFormat::tps, ".tps"},
    {ExchangeFormat::landmark_table, ".csv"}, {ExchangeFormat::score_table, ".csv"}};

ExchangeFormat format_of(const ConvertRequest& request) {
  const std::string extension = request.output.extension().string();
  if (request.format) {
    for (const Ending& ending : endings)
      if (ending.format == *request.format && extension != ending.text)
        throw InvalidInput(request.output.string() + ": the name of such a file ends in " + ending.text +
                           ", by which other programs know it");
    return *request.format;
  }
  for (const Ending& ending : endings)
    if (extension == ending.text) return ending.format;
  if (extension == ".ply" || extension == ".vtp")
    throw InvalidInput(
        request.output.string() + ": meshes go into a folder, one a shape; name it, and the format",
        {{RemedyKind::choose_format, extension.substr(1)}});
  return ExchangeFormat::ply;
}

// Throws InvalidInput if the output lies in the input's folder, because the next conversion would read it as
// a part of the input.
void require_outside(const ConvertRequest& request) {
  namespace fs = std::filesystem;
  if (!fs::is_directory(request.input)) return;
  const fs::path input = fs::weakly_canonical(request.input);
  for (fs::path folder = fs::weakly_canonical(fs::absolute(request.output)); folder != folder.root_path();
       folder = folder.parent_path())
    if (folder == input)
      throw InvalidInput(request.output.string() +
                         ": lies in the folder that is converted; name another place");
}

}  // namespace

ConvertSummary convert(const ConvertRequest& request, const RunContext& ctx) {
  const ExchangeFormat format = format_of(request);
  require_outside(request);
  ctx.step("read", 0);
  const ExchangeSet set = read_exchange_set(request);
  ConvertSummary summary{format, set.shapes.size(), 0, 0, set.notes};
  summary.landmarks = set.model ? set.model->points.size() : set.shapes.front().size();
  summary.files = write_exchange_set(set, request, format, ctx);
  return summary;
}

}  // namespace foramen
