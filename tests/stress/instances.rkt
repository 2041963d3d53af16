#lang racket/base
;; Renders instances of one bumpy sphere, then prints the mesh's triangles, the peak memory of the
;; process in bytes and the number of pixels that show an instance.
;;   racket tests/stress/instances.rkt COUNT STACKS SLICES
(module+ main
  (require racket/cmdline racket/flonum racket/port "../../main.rkt"
           (only-in "../shape/mesh-examples.rkt" bumpy-sphere make-generator uniform-in
                    random-direction))

  (define-values (count stacks slices)
    (apply values (map string->number (vector->list (current-command-line-arguments)))))
  (define mesh (bumpy-sphere stacks slices))
  (define g (make-generator 1))
  (define side (expt count 1/3))
  (define (place) (uniform-in g (- side) side))
  (define world
    (World (for/list ([_ (in-range count)])
             (Instance mesh
                       (Transform-compose
                        (Transform-translate (place) (place) (place))
                        (Transform-rotate (apply Float3 (random-direction g)) (uniform-in g 0.0 3.0))
                        (Transform-scale (uniform-in g 0.2 0.7)))))
           (DistantLight (Float3 1 2 3) (Float3 1 1 1)) (Float3 0 0 0)))
  (define image
    (render world (Camera-look-at (Float3 0 0 (* 3 side)) (Float3 0 0 0)) #:width 64 #:height 36
            #:samples 1))
  (define lit
    (for/sum ([x (in-flvector (Image-pixels image) 0 #f 3)]) (if (> x 0.0) 1 0)))

  ;; Where the system does not tell, what is in use now.
  (define (peak-bytes)
    (define status "/proc/self/status")
    (define line
      (and (file-exists? status)
           (regexp-match #px"VmHWM:\\s*(\\d+) kB" (call-with-input-file status port->string))))
    (if line (* 1024 (string->number (cadr line))) (current-memory-use)))
  (printf "~a ~a ~a\n" (Mesh-triangle-count mesh) (peak-bytes) lit))
