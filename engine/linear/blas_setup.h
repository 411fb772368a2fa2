// How OpenBLAS, where that is the BLAS under CHOLMOD, is to work: the settings are those of the whole process.
#pragma once

namespace dda {

// One thread, for good: OpenBLAS knows no setting per thread, and on the small dense blocks of these factors more of
// them cost several times the work they share (README).
//
// And the kernels for AVX2 on every processor that has it, unless OPENBLAS_CORETYPE says otherwise. OpenBLAS goes by
// the names of processors it knew when it was made: one that is newer gets kernels of 2004, which take two to three
// times as long, and two processors give a factor with other last digits, which rock that slides or breaks shows.
//
// Done once; to be called before the first factorization, while nobody else uses the BLAS.
void set_up_blas();

}  // namespace dda
