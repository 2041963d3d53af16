#lang racket/base
;; A target of one tile, for workers that cannot be trusted with the picture's: a tile is lent to them
;; as it is, and what they return is written to the picture only when it is complete.
(require racket/flonum net/base64 "../film.rkt" "../pixel.rkt" "../job.rkt" "../transport.rkt"
         "../../world/world.rkt" "../../base/float3.rkt")

(provide make-desk desk-lend! desk-commit! desk-fail! desk->list list->desk desk->bytes bytes->desk!
         job->order order->job Job-with-world)

;; make-desk : a Target that holds any one tile of the job's. make: as make-flvector.
(define (make-desk job target make)
  (define tiling (Job-tiling job))
  (define crop (Tiling-crop tiling))
  (define side (Tiling-tile tiling))
  (define pixels (* (min side (caddr crop)) (min side (cadddr crop))))
  (define errors (Target-errors target))
  (Target (make (* (target-places target) pixels) 0.0)
          (and errors (make (if (eqv? 1 (Job-samples job)) 0 (* 3 pixels)) 0.0))
          (make tally-places 0.0)))

(define (target-places target) (if (Target-errors target) 3 pixel-places))

;; Calls act for each row of a tile with where it starts in the desk and in the target, in pixels, and
;; its length.
(define (for-each-row job tile act)
  (define tiling (Job-tiling job))
  (define-values (x0 y0 x1 y1) (Tiling-bounds tiling tile))
  (define width (caddr (Tiling-crop tiling)))
  (for ([y (in-range y0 y1)])
    (act (* (- y y0) (- x1 x0)) (+ x0 (* y width)) (- x1 x0))))

(define (copy! to at from start count)
  (for ([k (in-range count)])
    (flvector-set! to (+ at k) (flvector-ref from (+ start k)))))

;; Puts the target's tile on the desk, as far as a worker has to know it.
(define (desk-lend! desk job target tile)
  (copy! (Target-tallies desk) 0 (Target-tallies target) (* tile tally-places) tally-places)
  (unless (Target-errors target)
    (for-each-row job tile
                  (lambda (own other count)
                    (copy! (Target-film desk) (* pixel-places own)
                           (Target-film target) (* pixel-places other) (* pixel-places count))))))

;; Writes the desk's tile to the target.
(define (desk-commit! desk job target tile)
  (define tallies (Target-tallies target))
  (define start (* tile tally-places))
  (define version (flvector-ref tallies start))
  (define places (target-places target))
  (define errors (Target-errors target))
  (flvector-set! tallies start (+ version 1.0))
  (memory-order-release)
  (for-each-row job tile
                (lambda (own other count)
                  (copy! (Target-film target) (* places other)
                         (Target-film desk) (* places own) (* places count))
                  (when (and errors (positive? (flvector-length errors)))
                    (copy! errors (* 3 other) (Target-errors desk) (* 3 own) (* 3 count)))))
  (copy! tallies (+ start 1) (Target-tallies desk) 1 (- tally-places 1))
  (memory-order-release)
  (flvector-set! tallies start (+ version 2.0)))

;; Leaves the whole tile in the error colour; the number of its first pixel in the picture.
(define (desk-fail! desk job target tile)
  (define tiling (Job-tiling job))
  (define crop (Tiling-crop tiling))
  (define-values (x0 y0 x1 y1) (Tiling-bounds tiling tile))
  (define pixels (* (- x1 x0) (- y1 y0)))
  (define film (Target-film desk))
  (define errors (Target-errors desk))
  (desk-lend! desk job target tile)
  (define (put! at . values)
    (for ([value (in-list values)] [k (in-naturals at)]) (flvector-set! film k value)))
  (for ([k (in-range pixels)])
    (cond
      [errors
       (put! (* 3 k) 1.0 0.0 1.0)
       (when (positive? (flvector-length errors))
         (for ([channel (in-range 3)]) (flvector-set! errors (+ channel (* 3 k)) 0.0)))]
      [else
       (define at (* pixel-places k))
       (define wanted (flvector-ref film (+ at pixel-places -1)))
       (define first (floor (* 0.5 (+ wanted 1.0))))
       (define second (- wanted first))
       (put! at first 0.0 first second 0.0 second 0.0 error-rays wanted wanted)]))
  (define samples (* 1.0 (or (Job-samples job) 0)))
  (flvector-set! (Target-tallies desk) tally-failed-place (* 1.0 pixels))
  (flvector-set! (Target-tallies desk) (- tally-failed-place 1)
                 (if errors
                     (* samples pixels)
                     (for/fold ([sum 0.0]) ([k (in-range pixels)])
                       (+ sum (flvector-ref film (+ -2 (* pixel-places (+ k 1))))))))
  (desk-commit! desk job target tile)
  (+ (car crop) x0 (* (Tiling-width tiling) (+ (cadr crop) y0))))

;; ----------------------------------------------------------------------------------------------
;; On the way to workers

(define (desk->list desk) (list (Target-film desk) (Target-errors desk) (Target-tallies desk)))
(define (list->desk parts) (apply Target parts))

;; What is on the desk, in characters that the connection carries as they are. lent?: only what a worker
;; has to know, which is no pixel where one pass gives each all of its samples.
(define (desk->bytes desk lent?)
  (define vectors (carried desk lent?))
  (define all (make-bytes (* 8 (apply + (map flvector-length vectors)))))
  (for*/fold ([at 0]) ([v (in-list vectors)] [x (in-flvector v)])
    (real->floating-point-bytes x 8 #f all at)
    (+ at 8))
  (base64-encode all #""))

(define (carried desk lent?)
  (if (and lent? (Target-errors desk))
      (list (Target-tallies desk))
      (filter values (desk->list desk))))

;; Raises exn:fail where there are not as many.
(define (bytes->desk! desk text lent?)
  (define all (base64-decode text))
  (define vectors (carried desk lent?))
  (unless (= (bytes-length all) (* 8 (apply + (map flvector-length vectors))))
    (error "a tile of another size"))
  (for*/fold ([at 0]) ([v (in-list vectors)] [k (in-range (flvector-length v))])
    (flvector-set! v k (floating-point-bytes->real all #f at (+ at 8)))
    (+ at 8))
  (void))

;; job->order : what a worker elsewhere is told of the job: a message, and the scene's file if the world
;; is to be taken from there, for it holds functions. Raises exn:fail:user where there is no file.
(define (job->order job)
  (with-handlers ([(lambda (e) (and (exn:fail:user? e) (Job-scene job)))
                   (lambda (e)
                     (list (value->message (Job-with-world job (make-World '() '() (make-Float3 0 0 0))))
                           (Job-scene job)))])
    (list (value->message job) #f)))

(define (Job-with-world job world)
  (Job world (Job-camera job) (Job-tiling job) (Job-samples job) (Job-seed job) (Job-sampler job)
       (Job-filter job) (Job-integrator job) (Job-max-depth job) (Job-scene job)))

(define (order->job order)
  (define job (message->value (car order)))
  (define scene (cadr order))
  (if scene
      (Job-with-world job (dynamic-require (string->path scene) 'world))
      job))
