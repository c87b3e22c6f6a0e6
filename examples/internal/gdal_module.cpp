// The module itself, see the header.

#include "gdal_module.h"

#include <CGAL/IO/read_GDAL_grid.h>
#include <CGAL/IO/read_OGR.h>

extern "C" {

void quality_mesh_read_graph_by_gdal(gdal_module::Graph_request& request);
void quality_mesh_read_grid_by_gdal(gdal_module::Grid_request& request);

void quality_mesh_read_graph_by_gdal(gdal_module::Graph_request& request) {
  request.coordinates =
      CGAL::IO::read_OGR(request.file_name, *request.graph, request.properties, request.layer);
}

void quality_mesh_read_grid_by_gdal(gdal_module::Grid_request& request) {
  request.sizes = CGAL::IO::read_GDAL_grid(request.file_name);
}

} // extern "C"
