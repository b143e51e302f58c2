// fuzz-seeds FOLDER
#include "fuzz/seeds.h"

#include <cstdio>

int main(int argc, char** argv) {
    if (argc != 2) {
        std::fputs("usage: fuzz-seeds FOLDER\n", stderr);
        return 2;
    }
    fuzz::writeSeeds(argv[1]);
    return 0;
}
