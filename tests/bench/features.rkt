#lang racket/base
;; What a feature costs scenes that lack it, and scenes that have it.
;;   racket tests/bench/features.rkt
;; Absent: the library is loaded a second time with the code for the feature cut out of its source,
;; and both render the same plain scene in turn; the median ratio of CPU times tells what the code
;; costs by being there. The edits name the text they cut, and fail where it is no longer found.
;; Kernels of materials and of shapes but spheres are closures a scene has or has not: for those it
;; lacks there is no code on its way.
;; Present: CPU time a sample against that of the plain scene, in turn as well.
(require racket/file racket/format racket/list racket/runtime-path racket/stream racket/string
         syntax/modread)

(provide write-features load-library edited-text absences (struct-out edit))

(define-runtime-path package-folder "../..")
(define-runtime-path worlds-file "feature-worlds.rkt")

(define (median numbers) (list-ref (sort numbers <) (quotient (length numbers) 2)))

;; file, text that must be there so many times, what takes its place
(struct edit (file text times replacement))

(define lights-edit
  (edit "private/integrate/path.rkt"
        "(when (and lights? (not (MaterialKernel-specular? kernel)))" 1 "(when #f"))
(define emission-edit
  (edit "private/integrate/path.rkt" "(when add-emission! " 2 "(when #f "))
(define media-edit
  (edit "private/integrate/path.rkt" "(define media (path-media scene medium))" 1
        "(define media #f)"))
(define textures-edit
  (edit "private/integrate/path.rkt" "(let ([prepare (MaterialKernel-prepare kernel)])" 1
        "(let ([prepare #f])"))
(define filter-edit
  (edit "private/render/pixel.rkt" "[filter\n                 (sample-next-pair! r i)" 1
        "[#f\n                 (sample-next-pair! r i)"))
(define sampled-sky-edit
  (edit "private/integrate/path.rkt" "[(fx< background-light 0) (flvector-set!" 1
        "[#t (flvector-set!"))
(define transmission-edit
  (edit "private/integrate/path.rkt" "(vertex (fx+ depth 1) (MaterialKernel-transmits? kernel))" 1
        "(vertex (fx+ depth 1) #f)"))
(define depth-edit (edit "private/integrate/path.rkt" "(when (fx< depth max-depth)" 1 "(when #t"))
(define unbounded-edit
  (edit "private/world/trace.rkt" "(unless (Scene-only-spheres? scene)" 1 "(unless #t"))
(define other-shapes-edit
  (edit "private/world/trace.rkt" "(if (fl> radius 0.0)" 2 "(if #t"))
(define lens-edit
  (edit "private/world/camera-kernel.rkt" "(define cast! (untimed-kernel camera" 1
        "(define cast! (pinhole-kernel camera"))
;; absences : row, the edits
(define absences
  (list (list "nothing: the same twice" '())
        (list "sampled lights" (list lights-edit))
        (list "emitters" (list emission-edit))
        (list "transmission" (list transmission-edit))
        (list "unbounded shapes and shapes other than spheres"
              (list unbounded-edit other-shapes-edit))
        (list "media" (list media-edit))
        (list "textures and bumps" (list textures-edit))
        (list "skies that are sampled" (list sampled-sky-edit))
        (list "pixel filters" (list filter-edit))
        (list "a lens and other projections" (list lens-edit))
        (list "all of these"
              (list lights-edit emission-edit transmission-edit depth-edit
                    media-edit textures-edit sampled-sky-edit filter-edit
                    unbounded-edit other-shapes-edit lens-edit))))

;; edited-text : the source of a file of the library with the edits made. Raises one line where one of
;; them does not find the text it is for as often as it should.
(define (edited-text file edits)
  (for/fold ([text (file->string (build-path package-folder file))]) ([e (in-list edits)])
    (define found (length (regexp-match* (regexp-quote (edit-text e)) text)))
    (unless (= found (edit-times e))
      (raise-user-error (format "features: expected ~s ~a times in ~a, found it ~a times"
                                (edit-text e) (edit-times e) file found)))
    (string-replace text (edit-text e) (edit-replacement e))))

;; A namespace with the library in it. All files that any edit is for are compiled anew, edited or
;; not: code compiled here is not quite as fast as what was compiled before.
(define all-files (remove-duplicates (map edit-file (cadr (last absences)))))
(define (load-library edits)
  (define texts
    (for/hash ([file (in-list all-files)])
      (values (simplify-path (build-path package-folder file))
              (edited-text file (filter (lambda (e) (equal? (edit-file e) file)) edits)))))
  (define load-file (current-load/use-compiled))
  (define namespace (make-base-namespace))
  (define (load-edited path name)
    (define text (hash-ref texts (simplify-path path) #f))
    (cond
      [(and text (or (not name) (symbol? name)))
       (define in (open-input-string text))
       (port-count-lines! in)
       (define-values (folder file-name folder?) (split-path path))
       (define form
         (check-module-form (with-module-reading-parameterization (lambda () (read-syntax path in)))
                            'module path))
       (parameterize ([current-load-relative-directory folder]
                      [current-module-declare-name
                       (or (current-module-declare-name) (make-resolved-module-path path))])
         (eval (compile form)))]
      [else (load-file path name)]))
  (parameterize ([current-namespace namespace] [current-load/use-compiled load-edited])
    (dynamic-require worlds-file #f)
    (dynamic-require 'raytrace/private/render/render #f))
  namespace)

;; A procedure that renders the scene of that name once and returns the CPU seconds it took.
(define (timed-render namespace name)
  (parameterize ([current-namespace namespace])
    (define (from module name) (dynamic-require module name))
    (define world ((from worlds-file 'feature-world) name))
    (define camera ((from worlds-file 'feature-camera) name))
    (define render (from 'raytrace/private/render/render 'render))
    (lambda ()
      (collect-garbage 'minor)
      (define start (current-process-milliseconds))
      (render world camera #:width 160 #:height 90 #:samples 4 #:integrator 'path
              #:schedule 'sequential)
      (/ (- (current-process-milliseconds) start) 1000.0))))

;; The median ratio of times a / b, measured in turn.
(define (median-ratio a b times)
  (a) (b)
  (median
   (for/list ([k (in-range times)])
     (if (even? k)
         (let ([first (a)]) (/ first (b)))
         (let ([first (b)]) (/ (a) first))))))

;; A stream of (list feature cost-as-a-part) : how much slower than without its code.
(define (absent-costs times)
  (define whole (timed-render (load-library '()) "nothing"))
  (for/stream ([absence (in-list absences)])
    (define stripped (timed-render (load-library (cadr absence)) "nothing"))
    (list (car absence) (- (median-ratio whole stripped times) 1.0))))

;; A stream of (list feature time-a-sample-as-a-part-of-the-plain-scene's)
(define (present-costs times)
  (define namespace (load-library '()))
  (define names
    (parameterize ([current-namespace namespace]) (dynamic-require worlds-file 'features)))
  (define plain (timed-render namespace (car names)))
  (for/stream ([name (in-list (cdr names))])
    (list name (median-ratio (timed-render namespace name) plain times))))

;; Both tables as text.
(define (write-features out #:times [times 25])
  (fprintf out "| code in the library for | costs a scene without it |\n|---|---|\n")
  (for ([row (in-stream (absent-costs times))])
    (fprintf out "| ~a | ~a% |\n" (car row) (~r (* 100 (cadr row)) #:precision '(= 1)))
    (flush-output out))
  (fprintf out "\n| 400 matte spheres under a sky, and | time a sample |\n|---|---|\n")
  (for ([row (in-stream (present-costs (max 3 (quotient times 5))))])
    (fprintf out "| ~a | x ~a |\n" (car row) (~r (cadr row) #:precision '(= 2)))))

(module+ main (write-features (current-output-port)))
