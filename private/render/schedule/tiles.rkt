#lang racket/base
;; What every schedule shares. A schedule is (run-X job target workers next-pass report!): next-pass
;; gives the counter of the tiles of another pass, or #f when there is none, and is called when all
;; tiles of the last one are in the target; report! is told of pixels left in the error colour and
;; raises if the render shall stop there. A tile is a transaction: it is rendered in scratch and written
;; to the target as a whole, its version (see Target) odd meanwhile; only then it counts as done. A tile
;; that was lost is given back and done again by whoever takes it next, with the same bits.
(require "../faults.rkt")

(provide make-tile-counter take-tile! wait-for-tile give-back! tile-done! tiles-done tiles-finished?
         tile-counter-stop! work render-carefully! render-with-faults call-with-lock fault? call-without-exit)

;; skip: bytes, not 0 for the tiles that are not to be rendered, or #f. lost: tiles given back. done:
;; how many are. due: how many are to be rendered.
(struct tile-counter (next total skip lost done due [stopped? #:mutable]))

(define (make-tile-counter total [skip #f])
  (define skipped (if skip (for/sum ([b (in-bytes skip)]) (if (positive? b) 1 0)) 0))
  (tile-counter (box 0) total skip (box '()) (box 0) (- total skipped) #f))

;; The next tile no worker has had, or one that was given back; #f when there is none or the render was
;; stopped.
(define (take-tile! counter)
  (define next (tile-counter-next counter))
  (define lost (tile-counter-lost counter))
  (define skip (tile-counter-skip counter))
  (let try ()
    (define tile (unbox next))
    (define others (unbox lost))
    (cond
      [(tile-counter-stopped? counter) #f]
      [(pair? others) (if (box-cas! lost others (cdr others)) (car others) (try))]
      [(>= tile (tile-counter-total counter)) #f]
      [(not (box-cas! next tile (+ tile 1))) (try)]
      [(and skip (positive? (bytes-ref skip tile))) (try)]
      [else tile])))

(define PAUSE-SECONDS 0.005)

;; The same where workers may be lost: #f only when every tile is done or the render was stopped.
(define (wait-for-tile counter)
  (or (take-tile! counter)
      (and (not (tiles-finished? counter))
           (begin
             (sleep PAUSE-SECONDS)
             (wait-for-tile counter)))))

;; A tile that was taken and not done.
(define (give-back! counter tile)
  (define lost (tile-counter-lost counter))
  (let try ()
    (define others (unbox lost))
    (unless (box-cas! lost others (cons tile others)) (try))))

(define (tile-done! counter)
  (define done (tile-counter-done counter))
  (let try ()
    (define count (unbox done))
    (unless (box-cas! done count (+ count 1)) (try))))

;; How many tiles have been rendered.
(define (tiles-done counter) (unbox (tile-counter-done counter)))

;; Whether there is nothing left to do.
(define (tiles-finished? counter)
  (or (tile-counter-stopped? counter) (>= (tiles-done counter) (tile-counter-due counter))))

(define (tile-counter-stop! counter) (set-tile-counter-stopped?! counter #t))

;; Renders tiles until there are none. at: a box that holds the tile in work, #f between tiles.
(define (work render-tile! counter at)
  (let loop ()
    (define tile (take-tile! counter))
    (when tile
      (set-box! at tile)
      (render-tile! tile #f)
      (set-box! at #f)
      (tile-done! counter)
      (loop))))

;; What a scene's function may raise; breaks are for the render.
(define (fault? e) (not (exn:break? e)))

;; Renders a tile in which something was raised again, pixel by pixel: one that raises another time is
;; left in the error colour and reported.
(define (render-carefully! render-tile! tile report!)
  (define (failure attempt!)
    (with-handlers ([fault? box]) (attempt!) #f))
  (render-tile! tile
                (lambda (pixel attempt! leave!)
                  (when (failure attempt!)
                    (define again (failure attempt!))
                    (when again
                      (leave!)
                      (report! pixel (unbox again)))))))

;; Renders a tile whatever is raised; the list of pairs of a pixel left in the error colour and why, a
;; text, the first of each text only.
(define (render-with-faults render-tile! tile)
  (define faults '())
  (define (add! pixel e)
    (define text (fault-text e))
    (unless (assoc text faults) (set! faults (cons (cons text pixel) faults))))
  (when (with-handlers ([fault? (lambda (e) #t)]) (render-tile! tile #f) #f)
    (render-carefully! render-tile! tile add!))
  (for/list ([fault (in-list faults)]) (cons (cdr fault) (car fault))))

;; The value of (use), where a scene's function that exits raises instead.
(define (call-without-exit use)
  (parameterize ([exit-handler (lambda (code) (error "left by (exit)"))])
    (use)))

;; The value of (use) while no one else has the lock, a semaphore; breaks wait until then.
(define (call-with-lock lock use)
  (parameterize-break #f (call-with-semaphore lock use)))
