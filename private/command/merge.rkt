#lang racket/base
;; raco raytrace merge: the parts of a picture become the picture.
(require racket/list "flags.rkt" "line.rkt" "keeper.rkt"
         "../render/film-file.rkt" "../render/film.rkt" "../render/pixel.rkt" "../render/memory.rkt"
         "../image/image.rkt" "../image/error.rkt" "../image/write.rkt")

(provide merge-parts)

(define flags
  `((usage-help "Joins all parts of a picture that --part rendered, in any order."
                "The picture is the same, to the bit, as one rendered at once.")
    (once-each
     [("-o" "--output") ,(lambda (flag file) file)
                        (("Write the picture to <file>: .ppm, .png, .pfm or .hdr;"
                          "by default the scene's name with .ppm")
                         "file")])))

(define (merge-parts program words)
  (define-values (output paths)
    (parse-words program words flags '("part" "more parts ...")
                 (lambda (output . paths) (values (and (pair? output) (car output)) paths))))
  (when (null? paths)
    (raise-user-error "merge: expected the files of all parts of a picture"))
  (define heads (for/list ([path (in-list paths)]) (part-header path)))
  (define first-head (car heads))
  (define settings (header-settings first-head))
  (define count (cadr (header-part first-head)))
  (define what (format "a part of the same picture as ~a" (car paths)))
  (for ([path (in-list (cdr paths))] [head (in-list (cdr heads))])
    (check-same-render path what (header-settings head) settings)
    (unless (= count (cadr (header-part head)))
      (raise-user-error (format "~a: expected ~a, found one of ~a parts, not of ~a"
                                path what (cadr (header-part head)) count))))
  (define missing
    (remove* (map (lambda (head) (car (header-part head))) heads) (range 1 (+ count 1))))
  (unless (null? missing)
    (raise-user-error
     (one-line (format "merge: missing ~a ~a of ~a" (if (null? (cdr missing)) "part" "parts")
                       (numbers-text missing) count))))
  (define file
    (or output (string-append (setting settings "scene") ".ppm")))
  (check-output-path file)
  (define image (join paths heads settings))
  (Image-write image file)
  (define error (Image-relative-error image))
  (eprintf "~a: ~ax~a, ~a samples a pixel~a, of ~a parts\n"
           file (Image-width image) (Image-height image) (setting settings "number of samples")
           (if error (format ", error ~a%" (real->decimal-string (* 100 error) 2)) "") count))

(define (part-header path)
  (define head (film-file-header path "a part of a picture"))
  (unless (eq? (header-kind head) 'part)
    (raise-user-error (format "~a: expected a part of a picture, found a checkpoint" path)))
  head)

(define (setting settings word) (cdr (assoc word settings)))

(define (join paths heads settings)
  (define size (setting settings "size"))
  (define crop-text (setting settings "crop"))
  (define crop (or crop-text (list 0 0 (car size) (cadr size))))
  (define tiling (Tiling (car size) (cadr size) (setting settings "tile") crop))
  (define numbers (* (caddr crop) (cadddr crop) 3))
  (define places (header-places (car heads)))
  (check-memory (* 8 places (quotient numbers 3)) (caddr crop) (cadddr crop))
  (define target
    (Target (make-pinned-flvector numbers +nan.0)
            (make-pinned-flvector (if (= places 3) 0 numbers) +nan.0)
            (make-pinned-flvector (* tally-places (tile-count tiling)) 0.0)))
  (define tiles
    (append* (for/list ([path (in-list paths)])
               (film-file-load! path "a part of a picture" tiling target))))
  (define lacking (- (tile-count tiling) (length (remove-duplicates tiles))))
  (unless (zero? lacking)
    (raise-user-error (format "merge: ~a tiles are in none of the parts" lacking)))
  (Target-image target (caddr crop) (cadddr crop)))

;; "2, 5-7 and 9", with runs of numbers drawn together.
(define (numbers-text numbers)
  (define runs
    (let collect ([rest (cdr numbers)] [low (car numbers)] [high (car numbers)])
      (cond
        [(and (pair? rest) (= (car rest) (+ high 1))) (collect (cdr rest) low (car rest))]
        [(pair? rest) (cons (run-text low high) (collect (cdr rest) (car rest) (car rest)))]
        [else (list (run-text low high))])))
  (apply string-append (add-between runs ", ")))

(define (run-text low high) (if (= low high) (format "~a" low) (format "~a-~a" low high)))
