#lang typed/racket/base
;; Pixel filters: how far from a pixel's middle its samples fall. Samples are drawn with the filter as
;; their density and all count alike (filter importance sampling; Ernst, Stamminger and Greiner 2006),
;; so that a pixel's samples remain its own. Widths are in pixels.
(require "../base/unsafe.rkt" "../base/check.rkt")

(provide FILTERS Filter-table check-filter Filter-offset filter-density)

;; box: the pixel's square. tent: falls to 0 at a pixel's distance. gaussian: standard deviation 0.5,
;; cut at 2 pixels. blackman-harris: the window of four terms (Harris 1978), 0 at 2 pixels.
(define FILTERS : (Listof Symbol) '(box tent gaussian blackman-harris))

(: check-filter (-> Symbol Void))
(define (check-filter name)
  (unless (memq name FILTERS)
    (raise-expected 'render "filter" (format "one of ~a" FILTERS) name)))

;; The density at a distance x from the middle along one axis, up to a factor; filters are products of
;; one for each axis.
(: filter-density (-> Symbol Flonum Flonum))
(define (filter-density name x)
  (define distance (flabs x))
  (case name
    [(box) (if (fl< distance 0.5) 1.0 0.0)]
    [(tent) (flmax 0.0 (fl- 1.0 distance))]
    [(gaussian) (if (fl< distance 2.0) (flexp (fl* -2.0 (fl* x x))) 0.0)]
    [else
     (if (fl< distance 2.0)
         (let ([turn (fl* 1.5707963267948966 x)])
           (fl+ (fl+ 0.35875 (fl* 0.48829 (flcos turn)))
                (fl+ (fl* 0.14128 (flcos (fl* 2.0 turn)))
                     (fl* 0.01168 (flcos (fl* 3.0 turn))))))
         0.0)]))

;; Cells of the table of offsets, and steps of the sum that makes it.
(define-syntax-rule (CELLS) 1024)
(define-syntax-rule (STEPS) 65536)
(define-syntax-rule (RADIUS) 2.0)

;; Filter-table : offsets at equal steps of the cumulated density, or #f for the box, which needs none.
(: Filter-table (-> Symbol (U #f FlVector)))
(define (Filter-table name)
  (if (eq? name 'box) #f (make-table name)))

(: make-table (-> Symbol FlVector))
(define (make-table name)
  (define step (fl/ (fl* 2.0 (RADIUS)) (fx->fl (STEPS))))
  (: middle (-> Fixnum Flonum))
  (define (middle k) (fl- (fl* step (fl+ 0.5 (fx->fl k))) (RADIUS)))
  (define total
    (let add : Flonum ([k : Fixnum 0] [sum : Flonum 0.0])
      (if (fx< k (STEPS)) (add (fx+ k 1) (fl+ sum (filter-density name (middle k)))) (fl+ sum 0.0))))
  (define table (make-flvector (fx+ 1 (CELLS))))
  (let fill ([cell : Fixnum 0] [k : Fixnum 0] [sum : Flonum 0.0])
    (define goal (fl/ (fl* total (fx->fl cell)) (fx->fl (CELLS))))
    (when (fx<= cell (CELLS))
      (let* ([density (if (fx< k (STEPS)) (filter-density name (middle k)) 0.0)]
             [next (fl+ sum density)])
        (cond
          [(and (fx< k (STEPS)) (or (fl< next goal) (fl= density 0.0)) (fx< cell (CELLS)))
           (fill cell (fx+ k 1) next)]
          [else
           (flvector-set! table cell
                          (if (fl> density 0.0)
                              (fl+ (fl- (middle k) (fl* 0.5 step))
                                   (fl* step (fl/ (fl- goal sum) density)))
                              (fl- (fl* step (fx->fl k)) (RADIUS))))
           (fill (fx+ cell 1) k sum)]))))
  ;; the ends are where the density is no longer 0
  (flvector-set! table (CELLS) (fl- 0.0 (flvector-ref table 0)))
  table)

;; Filter-offset : the offset from the pixel's middle for a number u in [0, 1).
(define-syntax-rule (Filter-offset table u0)
  (let* ([at (fl* u0 (fx->fl (CELLS)))]
         [cell (fl->fx (flfloor at))]
         [low (flvector-ref table cell)])
    (fl+ low (fl* (fl- at (fx->fl cell)) (fl- (flvector-ref table (fx+ cell 1)) low)))))
