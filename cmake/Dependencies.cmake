# Every library is a Debian package that tools/install-deps names.
find_package(Eigen3 3.4 REQUIRED NO_MODULE)
find_package(fmt 9 REQUIRED)
find_package(spdlog 1.10 REQUIRED)
find_package(OpenMP REQUIRED COMPONENTS CXX)
find_package(GSL 2.7 REQUIRED)
find_package(SUNDIALS 6 REQUIRED COMPONENTS cvode nvecserial sunlinsolklu)
find_package(nlohmann_json 3.11 REQUIRED)
find_package(CLI11 2.1 REQUIRED)
find_package(Boost 1.81 REQUIRED)
find_package(HDF5 1.10 REQUIRED COMPONENTS C)
find_package(PkgConfig REQUIRED)
pkg_check_modules(tomlplusplus REQUIRED IMPORTED_TARGET GLOBAL tomlplusplus)
pkg_check_modules(muparser REQUIRED IMPORTED_TARGET GLOBAL muparser)
add_library(tomlplusplus::tomlplusplus ALIAS PkgConfig::tomlplusplus)
add_library(muparser::muparser ALIAS PkgConfig::muparser)

find_path(UDUNITS2_INCLUDE udunits2.h REQUIRED)
find_library(UDUNITS2_LIBRARY udunits2 REQUIRED)
add_library(udunits2::udunits2 UNKNOWN IMPORTED GLOBAL)
set_target_properties(udunits2::udunits2 PROPERTIES
  IMPORTED_LOCATION ${UDUNITS2_LIBRARY} INTERFACE_INCLUDE_DIRECTORIES ${UDUNITS2_INCLUDE})

find_path(VOROPP_INCLUDE voro++/voro++.hh REQUIRED)
find_library(VOROPP_LIBRARY voro++ REQUIRED)
add_library(voropp::voropp UNKNOWN IMPORTED GLOBAL)
set_target_properties(voropp::voropp PROPERTIES
  IMPORTED_LOCATION ${VOROPP_LIBRARY} INTERFACE_INCLUDE_DIRECTORIES ${VOROPP_INCLUDE})

if(NOT TARGET hdf5::hdf5)
  add_library(hdf5::hdf5 INTERFACE IMPORTED GLOBAL)
  target_include_directories(hdf5::hdf5 SYSTEM INTERFACE ${HDF5_INCLUDE_DIRS})
  target_link_libraries(hdf5::hdf5 INTERFACE ${HDF5_LIBRARIES})
endif()
