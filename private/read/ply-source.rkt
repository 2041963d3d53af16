#lang racket/base
;; The rows of a PLY file as a stream of numbers, the same for text and for both binary orders.

(provide (struct-out source)
         make-text-source
         make-binary-source)

(require racket/fixnum
         racket/flonum
         "cursor.rkt"
         "file.rkt"
         "ply-header.rkt")

;; start-row!  (-> void)                 before each row
;; end-row!    (-> void)                 after each row
;; real!       (type what -> flonum)     the next number; what names it in the error
;; integer!    (type what -> fixnum)     the next number, which must be an integer
;; skip!       (type count -> void)      passes over numbers; count may be any natural number
;; position    (-> fixnum)               the byte offset
;; finish!     (-> void)                 raises unless only blanks are left
;; fail        (format argument ... ->)  raises a user error at the last number read
(struct source (start-row! end-row! real! integer! skip! position finish! fail))

;; A text has one row a line. c is at its first.
(define (make-text-source c)
  (define (start-row!)
    (cond
      [(cursor-token! c) (cursor-rewind-token! c)]
      [(cursor-at-end? c) (cursor-fail c "expected another row, found the end of the file")]
      [else (cursor-next-line! c) (start-row!)]))
  (define (end-row!)
    (when (cursor-token! c)
      (cursor-fail c "expected the end of the row, found ~a" (cursor-found c))))
  (define (skip! type count)
    (unless (eqv? count 0)
      (unless (cursor-token! c)
        (cursor-fail c "expected ~a more numbers in this row, found ~a" count (cursor-found c)))
      (skip! type (- count 1))))
  (define (finish!)
    (cond
      [(cursor-token! c)
       (cursor-fail c "expected the end of the file after the rows announced, found ~a"
                    (cursor-found c))]
      [(not (cursor-at-end? c))
       (cursor-next-line! c)
       (finish!)]))
  (source start-row! end-row!
          (λ (type what) (cursor-decimal! c what))
          (λ (type what) (cursor-integer! c what))
          skip!
          (λ () (cursor-pos c))
          finish!
          (λ message (apply cursor-fail c message))))

;; Binary rows start at offset; big? says which byte order.
(define (make-binary-source path bytes offset big?)
  (define end (bytes-length bytes))
  (define pos offset)
  (define last offset)
  (define (advance! size what)
    (define start pos)
    (set! last start)
    (when (fx> size (fx- end start))
      (fail-at-byte path start "expected ~a bytes for ~a, found the end of the file after ~a"
                    size what (fx- end start)))
    (set! pos (fx+ start size))
    start)
  (define (fail . message)
    (apply fail-at-byte path last message))
  (define (integer-at i type)
    (define (byte k) (bytes-ref bytes (fx+ i k)))
    (define (two a b) (fxior (fxlshift (byte a) 8) (byte b)))
    (define (four a b c d) (fxior (fxlshift (two a b) 16) (two c d)))
    (case type
      [(uint8) (byte 0)]
      [(int8) (signed (byte 0) 128)]
      [(uint16) (if big? (two 0 1) (two 1 0))]
      [(int16) (signed (if big? (two 0 1) (two 1 0)) 32768)]
      [(uint32) (if big? (four 0 1 2 3) (four 3 2 1 0))]
      [else (signed (if big? (four 0 1 2 3) (four 3 2 1 0)) 2147483648)]))
  (define (signed n half)
    (if (fx>= n half) (fx- n (fx* 2 half)) n))
  (define (real! type what)
    (define size (ply-type-size type))
    (define i (advance! size what))
    (if (ply-float-type? type)
        (floating-point-bytes->real bytes big? i (fx+ i size))
        (fx->fl (integer-at i type))))
  (define (integer! type what)
    (cond
      [(ply-float-type? type)
       (define x (real! type what))
       (unless (and (fl< (flabs x) 9e15) (fl= x (flfloor x)))
         (fail "expected an integer for ~a, found ~a" what x))
       (fl->fx x)]
      [else (integer-at (advance! (ply-type-size type) what) type)]))
  (define (skip! type count)
    (define size (* count (ply-type-size type)))
    (set! last pos)
    (when (> size (fx- end pos))
      (fail "expected ~a bytes, found the end of the file after ~a" size (fx- end pos)))
    (set! pos (fx+ pos size)))
  (define (finish!)
    (set! last pos)
    (unless (for/and ([b (in-bytes bytes pos)]) (memv b '(9 10 13 32)))
      (fail "expected the end of the file after the rows announced, found ~a more bytes"
            (fx- end pos))))
  (source void void real! integer! skip! (λ () pos) finish! fail))
