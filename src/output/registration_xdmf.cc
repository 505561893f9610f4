#include "registration_xdmf.h"

#include "prosup/output/registration_file.h"

namespace prosup::output {

namespace {

/// A data set of the HDF5 file.
std::string item(const std::string& path, std::size_t n_rows, unsigned n_columns, bool is_float) {
  const std::string dimensions =
      std::to_string(n_rows) + (n_columns > 1 ? " " + std::to_string(n_columns) : "");
  return "<DataItem Dimensions=\"" + dimensions + "\" NumberType=\"" +
         (is_float ? "Float\" Precision=\"8" : "UInt\" Precision=\"4") + "\" Format=\"HDF\">" +
         registration_h5 + ":/" + path + "</DataItem>";
}

std::string attribute(const std::string& name, bool at_nodes, const std::string& data) {
  return "          <Attribute Name=\"" + name + "\" AttributeType=\"" +
         (at_nodes ? "Vector\" Center=\"Node" : "Scalar\" Center=\"Cell") + "\">" + data +
         "</Attribute>\n";
}

std::string grid(const std::string& name, const std::string& type, const std::string& cells,
                 const std::string& points, const std::string& attributes) {
  return "        <Grid Name=\"" + name + "\" GridType=\"Uniform\">\n" +
         "          <Topology TopologyType=\"" + type + "\" " + cells + "</Topology>\n" +
         "          <Geometry GeometryType=\"XYZ\">" + points + "</Geometry>\n" + attributes +
         "        </Grid>\n";
}

std::string number_of(std::size_t n) {
  return "NumberOfElements=\"" + std::to_string(n) + "\">";
}

/// The cells of a breast, and the faces of its boundary.
std::string breast(const mesh::TetMesh& mesh, const std::string& name, bool is_loaded) {
  const std::size_t n = mesh.points.size(), m = mesh.cells.size(), k = mesh.boundary_faces.size();
  const std::string points = item(name + (is_loaded ? "/points" : "/unloaded"), n, 3, true);
  const std::string displacement =
      attribute("displacement", true, item(name + "/displacement", n, 3, true));
  std::string text =
      grid(name, "Tetrahedron", number_of(m) + item(name + "/cells", m, 4, false), points,
           displacement + attribute("tissue", false, item(name + "/tissue", m, 1, false)) +
               attribute("J", false, item(name + "/J", m, 1, true)));
  if (k > 0)
    text +=
        grid(name + " boundary", "Triangle",
             number_of(k) + item(name + "/boundary_faces", k, 3, false), points,
             displacement + attribute("part", false, item(name + "/boundary_parts", k, 1, false)));
  return text;
}

} // namespace

std::string xdmf_of(const PerPosition<mesh::UnloadedMesh>& meshes) {
  std::string text = "<?xml version=\"1.0\" ?>\n<Xdmf Version=\"2.0\">\n  <Domain>\n"
                     "    <Grid Name=\"registration\" GridType=\"Collection\" "
                     "CollectionType=\"Temporal\">\n";
  for (const bool is_loaded : {false, true}) {
    text += std::string("      <Grid Name=\"") + (is_loaded ? "loaded" : "unloaded") +
            "\" GridType=\"Collection\" CollectionType=\"Spatial\">\n        <Time Value=\"" +
            (is_loaded ? "1" : "0") + "\"/>\n";
    for (const Position position : both_positions)
      text += breast(meshes[position].mesh, name_of(position), is_loaded);
    text += "      </Grid>\n";
  }
  return text + "    </Grid>\n  </Domain>\n</Xdmf>\n";
}

} // namespace prosup::output
