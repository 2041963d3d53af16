#lang racket/base
;; The unit of time: the nearest hit of 200,000 rays against 500 spheres by a plain loop, compiled by
;; the system's C compiler where there is one; without it, seconds.
(require racket/system racket/file racket/port racket/string)

(provide calibration-unit)

(define source #<<C
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <time.h>
static uint64_t s = 42;
static double u(void) {
  uint64_t z = (s += 0x9E3779B97F4A7C15ull);
  z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ull;
  z = (z ^ (z >> 27)) * 0x94D049BB133111EBull;
  return (double)((z ^ (z >> 31)) >> 11) * 0x1p-53;
}
static double q[500][4];
int main(void) {
  for (int i = 0; i < 500; i++) {
    for (int k = 0; k < 3; k++) q[i][k] = 20 * u() - 10;
    q[i][3] = 0.1 + 0.4 * u();
  }
  double best = 1e9, sum = 0;
  for (int round = 0; round < 3; round++) {
    clock_t start = clock();
    for (int r = 0; r < 200000; r++) {
      double o[3], d[3], l = 0, near = INFINITY;
      for (int k = 0; k < 3; k++) { o[k] = 20 * u() - 10; d[k] = 2 * u() - 1; l += d[k] * d[k]; }
      l = 1 / sqrt(l);
      for (int k = 0; k < 3; k++) d[k] *= l;
      for (int i = 0; i < 500; i++) {
        double x = o[0] - q[i][0], y = o[1] - q[i][1], z = o[2] - q[i][2];
        double b = x * d[0] + y * d[1] + z * d[2];
        double e = b * b - (x * x + y * y + z * z - q[i][3] * q[i][3]);
        if (e >= 0) { double t = -b - sqrt(e); if (t <= 0) t = -b + sqrt(e); if (t > 0 && t < near) near = t; }
      }
      if (near < 1e9) sum += near;
    }
    double seconds = (double)(clock() - start) / CLOCKS_PER_SEC;
    if (seconds < best) best = seconds;
  }
  fprintf(stderr, "%f\n", sum);
  printf("%.4f\n", best);
  return 0;
}
C
  )

;; CPU seconds of one unit here and now; 1.0 where no C compiler is found.
(define (calibration-unit)
  (define compiler (find-executable-path "cc"))
  (cond
    [compiler
     (define folder (make-temporary-file "calibrate~a" 'directory))
     (dynamic-wind
      void
      (lambda ()
        (define program (build-path folder "unit"))
        (display-to-file source (build-path folder "unit.c"))
        (system* compiler "-O2" "-o" program (build-path folder "unit.c") "-lm")
        (string->number
         (string-trim (with-output-to-string
                        (lambda ()
                          (parameterize ([current-error-port (open-output-nowhere)])
                            (system* program)))))))
      (lambda () (delete-directory/files folder)))]
    [else 1.0]))
