#lang racket/base
;; Mutated files of every format: each loads or raises one line that names the file, soon, and
;; without allocating more than its size warrants. 300 of each; 10000 when RAYTRACE_STRESS is set.

(module+ test
  (require rackunit
           racket/file
           racket/fixnum
           racket/flonum
           "../../private/read/mesh.rkt"
           "mesh-files.rkt"
           "sphere-files.rkt")

  (define mutation-count (if (getenv "RAYTRACE_STRESS") 10000 300))
  (define seed 20240617)
  (define most-milliseconds 2000)
  (define most-bytes 30000000)

  ;; A mutated copy: one to three changes, each in one place.
  (define (mutate original pick)
    (for/fold ([content original]) ([_ (in-range (+ 1 (pick 3)))])
      (define length (bytes-length content))
      (define at (pick (+ length 1)))
      (define run (min (+ 1 (pick (vector-ref #(1 4 40) (pick 3)))) (- length at)))
      (define before (subbytes content 0 at))
      (define after (subbytes content at))
      (define (random-bytes n) (apply bytes (for/list ([_ (in-range n)]) (pick 256))))
      (case (pick 10)
        [(0) (bytes-append before (random-bytes run) (subbytes after run))]
        [(1) (bytes-append before (subbytes after run))]
        [(2) (bytes-append before (random-bytes (+ 1 (pick 8))) after)]
        [(3) (if (= 0 (pick 4)) before content)]
        [(4) (bytes-append before (subbytes after 0 run) after)]
        [(5) (bytes-append before (vector-ref tokens (pick (vector-length tokens))) after)]
        [else
         ;; One bit of a byte, or another sign of a number.
         (define copy (bytes-copy content))
         (when (< at length)
           (bytes-set! copy at
                       (if (= 0 (pick 2))
                           (bitwise-xor (bytes-ref content at) (arithmetic-shift 1 (pick 8)))
                           (bytes-ref number-bytes (pick (bytes-length number-bytes))))))
         copy])))

  (define number-bytes #"0123456789.-e/")

  (define tokens
    (vector #"\n" #" " #"\\\n" #"-" #"1e400" #" nan" #"999999999" #"/" #"#" #"\0" #"f 1 2 3\n"
            #"f -1 -2 -3\n" #"usemtl x\n" #"mtllib mesh.mtl\n" #"\377\377\377\177" #"0 0 0"))

  ;; What went wrong with this file, or #f. loaded is called when it could be read.
  (define (problem folder name loaded!)
    (define path (build-path folder name))
    (define bytes-before (current-memory-use 'cumulative))
    (define time-before (current-process-milliseconds))
    (define outcome #f)
    (define reading
      (thread
       (λ ()
         (set! outcome
               (with-handlers ([exn:fail:user? values] [exn:fail? values])
                 (read-mesh path))))))
    (define finished? (sync/timeout 60 reading))
    (define time (- (current-process-milliseconds) time-before))
    (define allocated (- (current-memory-use 'cumulative) bytes-before))
    (kill-thread reading)
    (cond
      [(not finished?) "hangs"]
      [(> time most-milliseconds) (format "takes ~a ms" time)]
      [(> allocated most-bytes) (format "allocates ~a bytes" allocated)]
      [(mesh-data? outcome)
       (loaded!)
       (and (not (sound? outcome)) "is read into a mesh that is not sound")]
      [(not (exn:fail:user? outcome)) (format "raises ~e" outcome)]
      [(not (regexp-match? #rx"^[^\n\r]*/mesh[.][a-z]+:( byte )?[0-9]+: expected [^\n\r]*$"
                           (exn-message outcome)))
       (format "gives the message ~s" (exn-message outcome))]
      [else #f]))

  ;; Finite positions, indices in range, groups that cover the triangles, one-line warnings.
  (define (sound? mesh)
    (define vertex-count (quotient (flvector-length (mesh-data-positions mesh)) 3))
    (define (fits? numbers width)
      (or (not numbers) (= (flvector-length numbers) (* width vertex-count))))
    (and (for/and ([x (in-flvector (mesh-data-positions mesh))]) (fl< (flabs x) +inf.0))
         (for/and ([v (in-fxvector (mesh-data-triangles mesh))]) (< -1 v vertex-count))
         (fits? (mesh-data-normals mesh) 3)
         (fits? (mesh-data-uvs mesh) 2)
         (= (fxvector-length (mesh-data-triangles mesh))
            (* 3 (for/fold ([end 0]) ([g (in-list (mesh-data-groups mesh))])
                   (if (= end (cadr g)) (+ end (caddr g)) -1))))
         (andmap (λ (w) (not (regexp-match? #rx"[\n\r]" w))) (mesh-data-warnings mesh))))

  ;; Mutates the file called name among files.
  (define (check-mutations title files name)
    (define source (make-pseudo-random-generator))
    (parameterize ([current-pseudo-random-generator source]) (random-seed seed))
    (define (pick n) (random n source))
    (define original (cdr (assoc name files)))
    (define mesh-name
      (for/first ([f (in-list files)] #:unless (regexp-match? #rx"mtl$" (car f))) (car f)))
    (define loaded 0)
    (define problems
      (call-with-folder
       files
       (λ (folder)
         (check-false (problem folder mesh-name void) "the file before any mutation")
         (for*/list ([i (in-range mutation-count)]
                     [mutated (in-value (mutate original pick))]
                     [found (in-value
                             (let ()
                               (call-with-output-file (build-path folder name) #:exists 'truncate
                                 (λ (out) (write-bytes mutated out)))
                               (problem folder mesh-name (λ () (set! loaded (+ 1 loaded))))))]
                     #:when found)
           (format "mutation ~a ~a: ~s" i found mutated)))))
    (printf "~a: ~a of ~a mutations load, the others give one line\n" title loaded mutation-count)
    (check-equal? problems '() title)
    (check-true (< 0 loaded mutation-count) title))

  (define (sphere-bytes kind)
    (call-with-folder '() (λ (folder)
                            (define path (build-path folder "sphere"))
                            (write-sphere kind 5 path)
                            (file->bytes path))))

  (for ([kind (in-list sphere-kinds)])
    (define name (string-append "mesh." (substring (symbol->string kind) 0 3)))
    (test-case (symbol->string kind)
      (check-mutations (symbol->string kind) (list (cons name (sphere-bytes kind))) name)))

  (define featured-files
    (list (cons "mesh.obj"
                (bytes-append #"# every feature\nmtllib mesh.mtl\no a\n"
                              #"v 0 0 0 1\nv 4 2 0\nv 0 4 0\nv 1 2 0\n"
                              #"vt 0 0\nvt 1 0\nvn 0 0 1\ng b\nusemtl red\nf 1/1/1 2/2/1 3//1 4/1/1\n"
                              #"usemtl blue\nf -4 -3 \\\n -1\ns 1\nl 1 2\nf 1//1 2//1 3//1 3//1\n"))
          (cons "mesh.mtl"
                (bytes-append #"newmtl red\nKd 1 0 0\nKs .5\nNs 10\nmap_Kd a.png\n"
                              #"newmtl blue\nd 0.5\nNi 1.5\nKe 1 2 3\nTr 0.5\nillum 2\n"))))

  (test-case "obj with every feature"
    (check-mutations "obj with every feature" featured-files "mesh.obj"))

  (test-case "mtl"
    (check-mutations "mtl" featured-files "mesh.mtl"))

  (test-case "binary garbage"
    (define source (make-pseudo-random-generator))
    (parameterize ([current-pseudo-random-generator source]) (random-seed seed))
    (for* ([name (in-list '("mesh.obj" "mesh.ply" "mesh.stl"))]
           [size (in-list '(0 1 83 84 1000 100000))])
      (define garbage (make-bytes size))
      (for ([i (in-range size)])
        (bytes-set! garbage i (random 256 source)))
      (call-with-folder (list (cons name garbage))
                        (λ (folder)
                          (define loaded? #f)
                          (check-false (problem folder name (λ () (set! loaded? #t))))
                          (check-false loaded?))))))
