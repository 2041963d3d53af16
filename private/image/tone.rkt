#lang typed/racket/base
;; From linear light to display values and back: the sRGB transfer function (IEC 61966-2-1),
;; Rec. 709 luminance, and an exact, allocation-free path from linear flonums to sRGB bytes.
(provide sRGB-encode sRGB-decode sRGB-byte sRGB-decoding-table luminance
         linear->sRGB-bytes linear->sRGB-bytes!)
(require racket/flonum racket/fixnum)

;; sRGB-encode : the display value of a linear one; 0 and 1 stay. Below 0 the linear segment goes
;; on, above 1 the power law. Relative error below 1e-12 on [0, 1].
(: sRGB-encode (-> Real Flonum))
(define (sRGB-encode linear)
  (define x (real->double-flonum linear))
  (if (fl<= x 0.0031308)
      (fl* 12.92 x)
      (fl- (fl* 1.055 (flexpt x (fl/ 1.0 2.4))) 0.055)))

;; sRGB-decode : the linear value of a display one, extended outside [0, 1] as sRGB-encode is.
(: sRGB-decode (-> Real Flonum))
(define (sRGB-decode encoded)
  (define v (real->double-flonum encoded))
  (if (fl<= v 0.04045)
      (fl/ v 12.92)
      (flexpt (fl/ (fl+ v 0.055) 1.055) 2.4)))

;; sRGB-byte : round(255 sRGB-encode(x)) of x clamped to [0, 1]; NaN gives 0.
(: sRGB-byte (-> Real Byte))
(define (sRGB-byte linear)
  (define x (real->double-flonum linear))
  (cond [(fl>= x 1.0) 255]
        [(fl> x 0.0) (assert (fl->exact-integer (flround (fl* 255.0 (sRGB-encode x)))) byte?)]
        [else 0]))

;; sRGB-decoding-table : the linear value of each sample 0 ... maximum of a file whose samples
;; are sRGB-encoded and whose white is maximum, which is positive.
(: sRGB-decoding-table (-> Positive-Fixnum FlVector))
(define (sRGB-decoding-table maximum)
  (for/flvector #:length (+ maximum 1) ([sample (in-range (+ maximum 1))])
    (sRGB-decode (fl/ (->fl sample) (->fl maximum)))))

;; luminance : Rec. 709 luminance of linear red, green and blue, in their unit.
(: luminance (-> Real Real Real Flonum))
(define (luminance red green blue)
  (fl+ (fl+ (fl* 0.2126 (real->double-flonum red)) (fl* 0.7152 (real->double-flonum green)))
       (fl* 0.0722 (real->double-flonum blue))))

;; ----------------------------------------------------------------------------------------------
;; Bytes by table. The byte is a step function of x with 255 steps; a bin of width 1/4096 is
;; narrower than the closest two steps (1/(12.92*255)) and so holds one of them at most.

;; The least flonum whose byte is the one given, by bisection on sRGB-byte itself.
(: least-with-byte (-> Fixnum Flonum))
(define (least-with-byte byte)
  (let search ([below : Flonum (sRGB-decode (/ (- byte 0.6) 255.0))]
               [above : Flonum (sRGB-decode (/ (- byte 0.4) 255.0))])
    (define middle (fl* 0.5 (fl+ below above)))
    (cond [(or (fl<= middle below) (fl>= middle above)) above]
          [(>= (sRGB-byte middle) byte) (search below middle)]
          [else (search middle above)])))

;; steps[b] is where byte b begins; past the last one lies infinity.
(: steps FlVector)
(define steps
  (for/flvector #:length 257 ([byte (in-range 257)])
    (cond [(eqv? byte 0) -inf.0]
          [(< 0 byte 256) (least-with-byte byte)]
          [else +inf.0])))

(: bytes-at-bins Bytes)
(define bytes-at-bins
  (let ([table (make-bytes 4096)])
    (for ([bin (in-range 4096)])
      (bytes-set! table bin (sRGB-byte (/ bin 4096.0))))
    table))

(define-syntax-rule (byte-by-table x)
  (cond [(fl>= x 1.0) 255]
        [(fl>= x 0.0)
         (let ([next (fx+ 1 (bytes-ref bytes-at-bins (fl->fx (fl* x 4096.0))))])
           (if (fl>= x (flvector-ref steps next)) next (fx- next 1)))]
        [else 0])) ; NaN too

;; linear->sRGB-bytes : one byte per number of a flvector, each equal to sRGB-byte of it.
(: linear->sRGB-bytes (-> FlVector Bytes))
(define (linear->sRGB-bytes linear)
  (define count (flvector-length linear))
  (define target (make-bytes count))
  (linear->sRGB-bytes! target 0 linear 0 count)
  target)

;; linear->sRGB-bytes! : the same for count numbers from start on, into target from target-start.
(: linear->sRGB-bytes! (-> Bytes Index FlVector Index Index Void))
(define (linear->sRGB-bytes! target target-start linear start count)
  (let loop ([i : Fixnum 0])
    (when (fx< i count)
      (let ([x (flvector-ref linear (fx+ start i))])
        (bytes-set! target (fx+ target-start i) (byte-by-table x))
        (loop (fx+ i 1))))))
