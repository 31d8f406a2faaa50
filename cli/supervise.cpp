#include "supervise.hpp"

#include <utility>

namespace pardel::cli {

Error interrupted() { return {ErrorKind::cancelled, "interrupted"}; }

Result<Meshed> supervise(const Interrupt& interrupt, ShowProgress show, Options options,
                         const std::function<Result<Meshed>(const Options&)>& work) {
  ProgressBar bar(show);
  options.progress = [&](const Progress& progress) {
    bar.update(progress.triangles, progress.estimate);
    return !interrupt.requested();
  };
  Result<Meshed> result = work(options);
  if (!result && result.error().kind == ErrorKind::cancelled) return interrupted();
  return result;
}

}  // namespace pardel::cli
