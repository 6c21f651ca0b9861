#include <table/file_kind.hpp>

#include <algorithm>
#include <array>

namespace tcert::table {
namespace {

using namespace std::string_view_literals;

constexpr std::size_t kLooked = 4096;
constexpr std::size_t kTextPerControl = 50;

struct Magic {
  std::string_view bytes;
  std::string_view name;
  std::string_view way_out;  ///< FILE stands for the file's name.
};

constexpr std::string_view kByGdal = "gdal_translate -of AAIGrid FILE out.asc";

constexpr std::array kMagics{
    Magic{"II*\0"sv, "a GeoTIFF (or another TIFF image)", kByGdal},
    Magic{"MM\0*"sv, "a GeoTIFF (or another TIFF image)", kByGdal},
    Magic{"II+\0"sv, "a GeoTIFF (or another TIFF image)", kByGdal},
    Magic{"MM\0+"sv, "a GeoTIFF (or another TIFF image)", kByGdal},
    Magic{"\x89PNG\r\n\x1a\n"sv,
          "a PNG image",
          "gdal_translate -of AAIGrid FILE out.asc for a terrain, convert FILE out.pgm for a map"},
    Magic{"\xFF\xD8\xFF"sv, "a JPEG image", kByGdal},
    Magic{"\x93NUMPY"sv,
          "a NumPy array",
          "numpy.savetxt('out.csv', numpy.load('FILE'), delimiter=',')"},
    Magic{"\x89HDF\r\n\x1a\n"sv, "an HDF5 or netCDF-4 file", kByGdal},
    Magic{"CDF\x01"sv, "a netCDF file", kByGdal},
    Magic{"CDF\x02"sv, "a netCDF file", kByGdal},
    Magic{"CDF\x05"sv, "a netCDF file", kByGdal},
    Magic{"DSAA"sv, "a Surfer grid", kByGdal},
    Magic{"DSBB"sv, "a Surfer grid", kByGdal},
    Magic{"DSRB"sv, "a Surfer grid", kByGdal},
    Magic{"EHFA_HEADER_TAG"sv, "an ERDAS image", kByGdal},
    Magic{"LASF"sv, "a LAS point cloud", "grid it first, with pdal or las2dem"},
    Magic{
        "SQLite format 3\0"sv,
        "an SQLite file (a ROS 2 bag or a GeoPackage)",
        "tcert check FILE and tcert import log for a bag, gdal_translate -of AAIGrid FILE out.asc "
        "for a terrain"},
    Magic{"\x89MCAP0\r\n"sv, "an MCAP recording", "tcert check FILE, tcert import log"},
    Magic{"#ROSBAG V2.0"sv,
          "a ROS 1 bag",
          "rosbags-convert --src FILE --dst out, or rostopic echo -b FILE -p /TOPIC > topic.csv"},
    Magic{"ULog\x01\x12\x35"sv, "a PX4 log", "ulog2csv FILE"},
    Magic{"PAR1"sv, "a Parquet file", "pandas.read_parquet('FILE').to_csv('out.csv')"},
    Magic{"BZh"sv, "compressed by bzip2", "bunzip2 it"},
    Magic{"\xFD\x37\x7AXZ\0"sv, "compressed by xz", "unxz it"},
    Magic{"PK\x03\x04"sv, "a zip archive (or a spreadsheet)", "unzip it, or save the sheet as CSV"},
    Magic{"\x1F\x8B"sv, "compressed by gzip", "gunzip it"},
    Magic{"\x28\xB5\x2F\xFD"sv, "compressed by zstd", "unzstd it"},
    Magic{"%PDF-"sv, "a PDF", "save its table as CSV"},
    Magic{"\xFF\xFE"sv, "UTF-16", "iconv -f UTF-16 -t UTF-8 FILE > out.csv"},
    Magic{"\xFE\xFF"sv, "UTF-16", "iconv -f UTF-16 -t UTF-8 FILE > out.csv"}};

[[nodiscard]] std::string with_name(std::string_view way_out, std::string_view file) {
  std::string text(way_out);
  constexpr std::string_view kPlace = "FILE";
  for (std::size_t at = text.find(kPlace); at != std::string::npos && !file.empty();
       at = text.find(kPlace, at + file.size())) {
    text.replace(at, kPlace.size(), file);
  }
  return text;
}

[[nodiscard]] bool is_no_text(char c) noexcept {
  const auto code = static_cast<unsigned char>(c);
  return code < 0x20U && c != '\t' && c != '\n' && c != '\r' && c != '\f';
}

}  // namespace

std::optional<FileKind> kind_of_binary(std::string_view bytes, std::string_view file) {
  for (const Magic& magic : kMagics) {
    if (bytes.substr(0, magic.bytes.size()) == magic.bytes) {
      return FileKind{std::string(magic.name), with_name(magic.way_out, file)};
    }
  }
  const std::string_view front = bytes.substr(0, kLooked);
  const auto controls =
      static_cast<std::size_t>(std::count_if(front.begin(), front.end(), is_no_text));
  if (front.find('\0') == std::string_view::npos && controls * kTextPerControl <= front.size()) {
    return std::nullopt;
  }
  return FileKind{std::string(kBinaryFile),
                  with_name("if it is a raster, gdal_translate -of AAIGrid FILE "
                            "out.asc",
                            file)};
}

std::string text_expected(const FileKind& kind) {
  return "text, but this is " + kind.name + ", not text: " + kind.way_out;
}

}  // namespace tcert::table
