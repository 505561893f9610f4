#include "prosup/core/error.h"
#include "prosup/core/output_file.h"
#include "prosup/core/remarks.h"
#include "prosup/core/text.h"
#include "prosup/image/image_files.h"
#include "prosup/image/image_io.h"
#include "prosup/output/transform_file.h"
#include "prosup/pipeline/commands.h"
#include "result_fields.h"

namespace prosup::pipeline {

namespace {

std::string ending_of(const std::filesystem::path& file) {
  const std::string name = lower_case(file.filename().string());
  for (const char* ending : {".h5", ".nrrd", ".mha"})
    if (ends_with(name, ending))
      return ending;
  throw Error("The format of the output '" + file.string() +
              "' is not known; use .h5 for a transform of ITK, and .nrrd or .mha for an image of "
              "vectors.");
}

image::VectorImage field(const FieldRequest& request, Remarks& remarks) {
  const ResultFields fields(request.result);
  if (request.like.empty())
    return fields.field(request.from, request.to);
  return fields.field_on(image::read_image(request.like, remarks).grid, request.from, request.to);
}

} // namespace

void run_field(const FieldRequest& request) {
  const OutputFileRules rules{
      image::files_of_image(request.like), request.overwrite, "", {}, ending_of(request.output)};
  if (request.from == request.to)
    throw Error("'--from' and '--to' are both '" + request.from +
                "', so that nothing would move; name two states.");
  Remarks remarks{Log(MPI_COMM_SELF)};
  OutputFile output(request.output, rules);
  const image::VectorImage found = field(request, remarks);
  if (output::is_transform(request.output))
    output::write_transform(found, output.path());
  else
    image::write_displacement(found, output.path());
  output.commit();
}

} // namespace prosup::pipeline
