# install and export, so that find_package(foramen) works
