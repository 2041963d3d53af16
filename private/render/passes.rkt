#lang typed/racket/base
;; A render as passes over its tiles: one where the samples are given, otherwise a pilot and then as
;; many as the goal needs, each with the samples where they pay. What a pass asks for is a function of
;; the film alone, so that the picture for an error is the same on any schedule.
(require "../base/unsafe-typed.rkt" "../base/unsafe.rkt" "../image/error.rkt"
         "film.rkt" "plan.rkt")

(provide (struct-out Goal) make-passes (struct-out Passes) MOST-SAMPLES)

(unsafe-require/typed racket/base
  [current-inexact-monotonic-milliseconds (-> Flonum)])

(define-type TileCounter Any)
(unsafe-require/typed "schedule/tiles.rkt"
  [make-tile-counter (-> Fixnum Bytes TileCounter)]
  [tiles-done (-> TileCounter Fixnum)])

;; samples: how many every pixel gets, or the most it may get where an error (the relative RMSE) or a
;; time is the goal; with both, what is reached first ends the render.
(struct Goal ([samples : Fixnum] [error : (U #f Flonum)] [seconds : (U #f Flonum)]))

;; The most samples a pixel gets where nobody says otherwise.
(define MOST-SAMPLES 65536)

;; next: the counter of the tiles of the next pass, after the film was told what it wants, or #f at
;; the end. progress: the part that is done, from 0 to 1, as far as can be told. count: the passes so
;; far. stopped-by: why there is no next one. state: what has to be known beside the film to go on
;; from here in another process, and resume! to do so before the first pass.
(struct Passes ([next : (-> (U #f TileCounter))] [progress : (-> Flonum)]
                [count : (-> Fixnum)] [stopped-by : (-> Symbol)]
                [state : (-> State)] [resume! : (-> State Void)]))

;; The number of the pass and seconds so far; rays before this pass, in it, and in it and all after.
(define-type State (List Fixnum Flonum Flonum Flonum Flonum))

;; A pass that would bring less than this part of what is there is not worth its start.
(define-syntax-rule (LEAST-PASS) 0.01)

;; The part of the time left that a pass is planned to fill, and the part of the whole that is no
;; longer worth one: rates vary.
(define-syntax-rule (TIME-SHARE) 0.7)
(define-syntax-rule (TIME-LEFT) 0.03)

;; done: a byte for each tile, not 0 for those that are not to be rendered. Without a film (where
;; pixels are finished in one pass) there is only that one.
(: make-passes (->* ((U #f FlVector) Fixnum Fixnum Goal) (Bytes) Passes))
(define (make-passes film-or-none width tile-count goal [skip (make-bytes tile-count 0)])
  (define film (or film-or-none (flvector)))
  (define error (Goal-error goal))
  (define seconds (Goal-seconds goal))
  ;; samples are added in pairs, one of each stream
  (define most
    (let ([samples (Goal-samples goal)])
      (if (and (or error seconds) (> samples 1)) (fxand samples -2) samples)))
  (define start (current-inexact-monotonic-milliseconds))
  (define earlier : Flonum 0.0)
  (define resumed? : Boolean #f)
  (define count : Fixnum 0)
  (define stopped-by 'samples)
  (define counter : (U #f TileCounter) #f)
  ;; rays before this pass, in it, and in it and all that are expected to follow
  (define done : Flonum 0.0)
  (define now : Flonum 1.0)
  (define ahead : Flonum 1.0)

  (: start-pass! (-> Flonum Flonum TileCounter))
  (define (start-pass! pass-cost cost-ahead)
    (set! done (Film-rays film))
    (begin-pass! pass-cost cost-ahead))

  (: begin-pass! (-> Flonum Flonum TileCounter))
  (define (begin-pass! pass-cost cost-ahead)
    (define fresh (make-tile-counter tile-count skip))
    (set! now pass-cost)
    (set! ahead (flmax pass-cost cost-ahead))
    (set! count (fx+ count 1))
    (set! counter fresh)
    fresh)

  (: stop! (-> Symbol #f))
  (define (stop! why)
    (set! stopped-by why)
    #f)

  (: elapsed (-> Flonum))
  (define (elapsed)
    (fl+ earlier (fl/ (fl- (current-inexact-monotonic-milliseconds) start) 1000.0)))

  ;; the rays the next pass has time for, +inf.0 without a limit; rays are traced as fast as so far
  (: affordable (-> Flonum))
  (define (affordable)
    (if seconds
        (let* ([passed (elapsed)]
               [left (fl- seconds passed)])
          (if (fl< left (fl* (TIME-LEFT) seconds))
              0.0
              (fl* (fl* (TIME-SHARE) left) (fl/ (Film-rays film) passed))))
        +inf.0))

  (: count-skipped (-> Fixnum))
  (define (count-skipped)
    (for/fold ([sum : Fixnum 0]) ([byte (in-bytes skip)]) (if (eqv? byte 0) sum (fx+ sum 1))))

  (: next (-> (U #f TileCounter)))
  (define (next)
    (cond
      [resumed?
       (set! resumed? #f)
       (set! count (fx- count 1))
       (begin-pass! now ahead)]
      [(= count 0)
       (Film-want! film (if (or error seconds) (min most PILOT-SAMPLES) most))
       (start-pass! 1.0 1.0)]
      [(not (or error seconds)) (stop! 'samples)]
      [(and error (error-reached? error)) (stop! 'error)]
      [else (next-planned)]))

  (: error-reached? (-> Flonum Boolean))
  (define (error-reached? error)
    (define height (fxquotient (fxquotient (flvector-length film) (PIXEL-PLACES)) width))
    (define found (Image-relative-error (Film-image film width height)))
    (and found (fl<= found error)))

  (: next-planned (-> (U #f TileCounter)))
  (define (next-planned)
    (define rays (affordable))
    (define least (fl* (LEAST-PASS) (Film-rays film)))
    (define-values (wanted cost-ahead)
      (if error (Film-plan-error! film width error most) (values +inf.0 +inf.0)))
    (cond
      [(fl< rays least) (stop! 'seconds)]
      [(fl= wanted 0.0) (stop! 'most-samples)]
      [(fl< wanted rays) (start-pass! wanted cost-ahead)]
      [else
       (define planned (Film-plan-cost! film width rays most))
       (if (fl= planned 0.0) (stop! 'most-samples) (start-pass! planned planned))]))

  (: progress (-> Flonum))
  (define (progress)
    (define part (if counter (fl/ (fx->fl (fx+ (count-skipped) (tiles-done counter))) (fx->fl tile-count)) 0.0))
    (define by-rays
      (cond
        [(not (or error seconds)) part]
        [(and (= count 1) (or error seconds)) 0.0]
        [else (fl/ (fl+ done (fl* part now)) (fl+ done ahead))]))
    (if seconds (flmax by-rays (flmin 1.0 (fl/ (elapsed) seconds))) by-rays))

  (: state (-> State))
  (define (state) (list count (elapsed) done now ahead))

  (: resume! (-> State Void))
  (define (resume! state)
    (set! count (car state))
    (set! earlier (cadr state))
    (set! done (caddr state))
    (set! now (cadddr state))
    (set! ahead (car (cddddr state)))
    (set! resumed? (> count 0)))

  (Passes next progress (lambda () count) (lambda () stopped-by) state resume!))

(: Film-rays (-> FlVector Flonum))
(define (Film-rays film)
  (let each : Flonum ([at : Fixnum 0] [sum : Flonum 0.0])
    (if (fx< at (flvector-length film))
        (each (fx+ at (PIXEL-PLACES)) (fl+ sum (flvector-ref film (fx+ at (rays-place)))))
        (fl+ sum 0.0))))
