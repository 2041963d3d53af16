#lang racket/base
;; Radiance RGBE pictures (.hdr, .pic): linear, three mantissas of 8 bits and the exponent they share.
;; Writes run-length encoded lines, top first; reads flat and both kinds of encoded lines from any
;; corner. Source: G. Ward, Real Pixels, Graphics Gems II, 1991; Radiance, File Formats.
(provide Image-write-hdr Image-read-hdr)
(require racket/flonum racket/fixnum "image.rkt" "source.rkt")

;; A mantissa m with the exponent byte e > 0 stands for m*2^(e-136); e = 0 is black.
(define EXPONENT-BIAS 136)
(define units
  (for/flvector #:length 256 ([e (in-range 256)])
    (if (eqv? e 0) 0.0 (flexpt 2.0 (->fl (- e EXPONENT-BIAS))))))

;; Lines of other lengths are never run-length encoded channel by channel.
(define MINIMUM-ENCODED 8)
(define MAXIMUM-ENCODED 32767)
(define (encodable? width)
  (<= MINIMUM-ENCODED width MAXIMUM-ENCODED))

(define LONGEST-RUN 127)
(define LONGEST-LITERAL 128)

;; The pixels that one byte of a file stands for at most, so that what a header claims is refused
;; before memory follows it: encoded channels reach 16, whole pixels repeated more.
(define PIXELS-PER-BYTE 1024)

;; What was applied to a picture in all, within limits that keep every sample finite.
(define LARGEST-FACTOR 1e100)

;; ----------------------------------------------------------------------------------------------
;; Writing

;; Image-write-hdr : writes the image to an output port, linear, without correction or exposure.
;; Each channel is off by less than 1/256 of its pixel's largest; negative numbers and NaN become
;; 0, pixels below 2^-128 black, and numbers beyond the range its end, 255*2^119.
(define (Image-write-hdr image out)
  (define width (Image-width image))
  (define height (Image-height image))
  (define pixels (Image-pixels image))
  (define line (make-bytes (* 4 width)))
  (define encoded (and (encodable? width) (make-bytes (+ 4 (* 8 width)))))
  (define scratch (make-bytes 8))
  (write-string (format "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y ~a +X ~a\n" height width) out)
  (for ([y (in-range height)])
    (for ([x (in-range width)])
      (define at (fx* 3 (fx+ (fx* y width) x)))
      (store-pixel! line (fx* 4 x) scratch
                    (flvector-ref pixels at)
                    (flvector-ref pixels (fx+ at 1))
                    (flvector-ref pixels (fx+ at 2))))
    (if encoded
        (write-bytes encoded out 0 (encode-line! encoded line width))
        (write-bytes line out)))
  (void))

;; Stores red, green, blue and exponent. The largest mantissa is 128 at least, so that no pixel can
;; be taken for the mark of a repetition, which is 1 1 1.
(define (store-pixel! line at scratch red green blue)
  (define r (within-range red))
  (define g (within-range green))
  (define b (within-range blue))
  (define exponent (exponent-byte scratch (flmax r (flmax g b))))
  (cond [(fx<= exponent 0)
         (for ([k (in-range 4)]) (bytes-set! line (fx+ at k) 0))]
        [else
         (define unit (flvector-ref units exponent))
         (bytes-set! line at (mantissa r unit))
         (bytes-set! line (fx+ at 1) (mantissa g unit))
         (bytes-set! line (fx+ at 2) (mantissa b unit))
         (bytes-set! line (fx+ at 3) exponent)]))

(define LARGEST (* 255.0 (flexpt 2.0 (->fl (- 255 EXPONENT-BIAS)))))

(define (within-range x)
  (cond [(fl> x 0.0) (flmin x LARGEST)]
        [else 0.0])) ; negative or NaN

;; The exponent byte, if positive, of the unit in which x is 128 to 256.
(define (exponent-byte scratch x)
  (real->floating-point-bytes x 8 #t scratch)
  (define exponent ; that of x in [1,2)*2^exponent, unless it is subnormal and thus too small anyway
    (fx- (fxior (fxlshift (bytes-ref scratch 0) 4) (fxrshift (bytes-ref scratch 1) 4)) 1023))
  (fx+ exponent (- EXPONENT-BIAS 7)))

(define (mantissa x unit)
  (fxmin 255 (fl->fx (flround (fl/ x unit)))))

;; The line with its mark and its four channels one after the other, each in packets: 128 + n and a
;; byte are a run of n, n up to 128 and n bytes are those. Returns the number of bytes.
(define (encode-line! encoded line width)
  (bytes-set! encoded 0 2)
  (bytes-set! encoded 1 2)
  (bytes-set! encoded 2 (fxrshift width 8))
  (bytes-set! encoded 3 (fxand width 255))
  (for/fold ([to 4]) ([channel (in-range 4)])
    (define (sample i) (bytes-ref line (fx+ (fx* 4 i) channel)))
    ;; how many bytes from i on are equal, if fewer than so many
    (define (run-length i most)
      (define byte (sample i))
      (define end (fxmin width (fx+ i most)))
      (let extend ([k (fx+ i 1)])
        (if (and (fx< k end) (eqv? (sample k) byte)) (extend (fx+ k 1)) (fx- k i))))
    ;; where a run begins that is worth the end of the literal, or the literal is full
    (define (literal-end i)
      (define end (fxmin width (fx+ i LONGEST-LITERAL)))
      (let extend ([k (fx+ i 1)])
        (if (and (fx< k end) (fx< (run-length k 3) 3)) (extend (fx+ k 1)) k)))
    (let packet ([i 0] [to to])
      (define run (if (fx< i width) (run-length i LONGEST-RUN) 0))
      (cond [(eqv? run 0) to]
            [(fx> run 1)
             (bytes-set! encoded to (fx+ 128 run))
             (bytes-set! encoded (fx+ to 1) (sample i))
             (packet (fx+ i run) (fx+ to 2))]
            [else
             (define end (literal-end i))
             (bytes-set! encoded to (fx- end i))
             (for ([k (in-range i end)] [to (in-naturals (fx+ to 1))])
               (bytes-set! encoded to (sample k)))
             (packet end (fx+ to (fx+ 1 (fx- end i))))]))))

;; ----------------------------------------------------------------------------------------------
;; Reading

;; Image-read-hdr : the Image in a Radiance picture of RGB, divided by the exposures and the colour
;; corrections that its header says were applied; its primaries are not converted. Raises
;; exn:fail:user with the file and the byte offset when it is malformed.
(define (Image-read-hdr path)
  (define bytes (read-picture-file path '(#"#?") "#?RADIANCE"))
  (define-values (corrections after-header) (read-header path bytes))
  (define-values (slow fast start) (read-resolution path bytes after-header))
  (define lines (axis-size slow))
  (define line-length (axis-size fast))
  (unless (<= (* lines line-length) (* PIXELS-PER-BYTE (bytes-length bytes)))
    (picture-error path "byte ~a: expected a size that ~a bytes can hold, found ~ax~a pixels"
                   after-header (bytes-length bytes) line-length lines))
  (define rgbe (read-lines path bytes start lines line-length))
  (define width (if (axis-x? fast) line-length lines))
  (define height (if (axis-x? fast) lines line-length))
  (make-Image width height (lay-out rgbe slow fast width height corrections)))

;; One axis of the order in which pixels come: x or y, whether it runs rightwards or downwards.
(struct axis (x? forward? size))

;; The header's lines up to an empty one: three factors that were applied to red, green and blue, and
;; the offset after it. Lines with other settings, or indented ones of earlier pictures, tell nothing.
(define (read-header path bytes)
  (let next-line ([at 0] [corrections '(1.0 1.0 1.0)])
    (define-values (line after) (header-line path bytes at))
    (define (setting name) ; the offset of the value, or #f
      (and (starts-with? line name) (+ at (bytes-length name))))
    (define (factors value-at count expected)
      (define factors (map finite-decimal (words-of (subbytes line (- value-at at)))))
      (define applied
        (and (= (length factors) count)
             (andmap (lambda (f) (and f (positive? f))) factors)
             (map * corrections
                  (if (= count 1) (list* (car factors) (car factors) factors) factors))))
      (unless (and applied (andmap (lambda (f) (<= (/ LARGEST-FACTOR) f LARGEST-FACTOR)) applied))
        (picture-error path "byte ~a: expected ~a of 1e-100 to 1e100, found ~a"
                       value-at expected (show-bytes (subbytes line (- value-at at)))))
      applied)
    (cond [(equal? line #"") (values corrections after)]
          [(setting #"FORMAT=")
           => (lambda (value-at)
                (define value (words-of (subbytes line (- value-at at))))
                (unless (equal? value '(#"32-bit_rle_rgbe"))
                  (picture-error path "byte ~a: expected the format 32-bit_rle_rgbe, found ~a"
                                 value-at (show-bytes (subbytes line (- value-at at)))))
                (next-line after corrections))]
          [(setting #"EXPOSURE=")
           => (lambda (value-at)
                (next-line after (factors value-at 1 "an exposure")))]
          [(setting #"COLORCORR=")
           => (lambda (value-at)
                (next-line after (factors value-at 3 "a colour correction, three factors")))]
          [else (next-line after corrections)])))

;; The line that begins at an offset, without its end, and the offset after that.
(define (header-line path bytes at)
  (define end (bytes-length bytes))
  (define stop
    (let extend ([i at])
      (if (or (= i end) (eqv? (bytes-ref bytes i) 10)) i (extend (+ i 1)))))
  (when (= stop end)
    (picture-error path "byte ~a: expected a whole header, an empty line and the resolution, found ~a"
                   at (show-bytes (subbytes bytes at (min end (+ at 21))))))
  (define return? (and (> stop at) (eqv? (bytes-ref bytes (- stop 1)) 13)))
  (values (subbytes bytes at (if return? (- stop 1) stop)) (+ stop 1)))

(define (starts-with? bytes start)
  (define size (bytes-length start))
  (and (>= (bytes-length bytes) size) (equal? (subbytes bytes 0 size) start)))

(define (words-of bytes)
  (regexp-match* #px#"[^ \t]+" bytes))

;; The line such as -Y 480 +X 640: the axis that changes from line to line, the one within a line,
;; and the offset after it. Y grows upwards, X to the right.
(define (read-resolution path bytes at)
  (define-values (line after) (header-line path bytes at))
  (define match
    (regexp-match #px#"^([-+])([XY]) +([0-9]{1,18}) +([-+])([XY]) +([0-9]{1,18}) *$" line))
  (define (place-axis sign name size)
    (define x? (equal? name #"X"))
    (axis x? (eq? x? (equal? sign #"+")) (string->number (bytes->string/latin-1 size))))
  (define axes
    (if match
        (apply (lambda (sign name size sign-2 name-2 size-2)
                 (list (place-axis sign name size) (place-axis sign-2 name-2 size-2)))
               (cdr match))
        '()))
  (unless (and match
               (not (eq? (axis-x? (car axes)) (axis-x? (cadr axes))))
               (andmap (lambda (a) (positive? (axis-size a))) axes))
    (picture-error path "byte ~a: expected a resolution such as -Y 480 +X 640, found ~a"
                   at (show-bytes line)))
  (values (car axes) (cadr axes) after))

;; All pixels as they come, four bytes each. Memory follows what is decoded.
(define (read-lines path bytes start lines line-length)
  (define out (open-output-bytes))
  (define end (bytes-length bytes))
  (define line (and (encodable? line-length) (make-bytes (* 4 line-length))))
  (for/fold ([at start]) ([_ (in-range lines)])
    (cond [(and line
                (<= (+ at 4) end)
                (eqv? (bytes-ref bytes at) 2)
                (eqv? (bytes-ref bytes (+ at 1)) 2)
                (< (bytes-ref bytes (+ at 2)) 128))
           (define found (integer-bytes->integer bytes #f #t (+ at 2) (+ at 4)))
           (unless (= found line-length)
             (picture-error path "byte ~a: expected a line of ~a pixels, found one of ~a"
                            (+ at 2) line-length found))
           (define after (decode-channels! path bytes (+ at 4) line line-length))
           (write-bytes line out)
           after]
          [else (decode-pixels path bytes at out line-length)]))
  (get-output-bytes out #t))

;; A line of four encoded channels into the buffer; the offset after it.
(define (decode-channels! path bytes start line line-length)
  (define end (bytes-length bytes))
  (for/fold ([at start]) ([channel (in-range 4)])
    (let packet ([at at] [i 0])
      (cond
        [(fx= i line-length) at]
        [else
         (define mark (if (fx< at end) (bytes-ref bytes at) 0))
         (define run? (fx> mark 128))
         (define count (if run? (fx- mark 128) mark))
         (define after (fx+ at (if run? 2 (fx+ 1 count))))
         (unless (and (fx< at end) (fx<= after end))
           (picture-error path "byte ~a: expected a whole line of pixels, found the end of the file"
                          (min at end)))
         (unless (fx<= 1 count (fx- line-length i))
           (picture-error path "byte ~a: expected a run of 1 to ~a pixels, found one of ~a"
                          at (- line-length i) count))
         (for ([k (in-range count)])
           (bytes-set! line (fx+ (fx* 4 (fx+ i k)) channel)
                       (bytes-ref bytes (fx+ at (if run? 1 (fx+ 1 k))))))
         (packet after (fx+ i count))]))))

;; A line of pixels one by one to the port; the offset after it. 1 1 1 n repeats the last pixel n
;; times, and where such marks follow each other, they are digits, the lowest first.
(define (decode-pixels path bytes start out line-length)
  (define end (bytes-length bytes))
  (define (check-pixel at)
    (unless (<= (+ at 4) end)
      (picture-error path "byte ~a: expected a whole line of pixels, found the end of the file" at)))
  (define (repetition? at)
    (and (fx<= (fx+ at 4) end)
         (eqv? (bytes-ref bytes at) 1)
         (eqv? (bytes-ref bytes (fx+ at 1)) 1)
         (eqv? (bytes-ref bytes (fx+ at 2)) 1)))
  (let next ([at start] [left line-length] [shift 0])
    (cond
      [(eqv? left 0) at]
      [(repetition? at)
       (define count (arithmetic-shift (bytes-ref bytes (+ at 3)) (min shift 48)))
       (when (= at start)
         (picture-error path "byte ~a: expected a pixel, found its repetition" at))
       (unless (<= count left)
         (picture-error path "byte ~a: expected a repetition of at most ~a pixels, found ~a"
                        at left count))
       (repeat-pixel bytes (- at 4 (quotient shift 2)) out count)
       (next (+ at 4) (- left count) (+ shift 8))]
      [else
       ;; the pixels up to the next mark go out at once
       (define stop
         (let extend ([k at] [left left])
           (if (or (eqv? left 0) (repetition? k) (fx> (fx+ k 4) end))
               k
               (extend (fx+ k 4) (fx- left 1)))))
       (when (= stop at) (check-pixel at))
       (write-bytes bytes out at stop)
       (next stop (- left (quotient (- stop at) 4)) 0)])))

(define (repeat-pixel bytes at out count)
  (define chunk-pixels (min count 1024))
  (define chunk (make-bytes (* 4 chunk-pixels)))
  (for ([k (in-range 0 (* 4 chunk-pixels) 4)])
    (bytes-copy! chunk k bytes at (+ at 4)))
  (let write-chunk ([left count])
    (unless (eqv? left 0)
      (define pixels (min left chunk-pixels))
      (write-bytes chunk out 0 (* 4 pixels))
      (write-chunk (- left pixels)))))

;; The samples of an image with its top row first, from pixels in the order of two axes.
(define (lay-out rgbe slow fast width height corrections)
  (define-values (red green blue) (apply values corrections))
  (define pixels (make-flvector (* 3 width height)))
  (define (stride a) (* (if (axis-x? a) 3 (* 3 width)) (if (axis-forward? a) 1 -1)))
  (define (first-place a) (if (axis-forward? a) 0 (- (* (stride a) (- (axis-size a) 1)))))
  (define origin (+ (first-place slow) (first-place fast)))
  (define slow-stride (stride slow))
  (define fast-stride (stride fast))
  (define line-length (axis-size fast))
  (for ([i (in-range (axis-size slow))])
    (for ([j (in-range line-length)])
      (define from (fx* 4 (fx+ (fx* i line-length) j)))
      (define to (fx+ origin (fx+ (fx* i slow-stride) (fx* j fast-stride))))
      (define unit (flvector-ref units (bytes-ref rgbe (fx+ from 3))))
      (define-syntax-rule (store! channel correction)
        (flvector-set! pixels (fx+ to channel)
                       (fl/ (fl* (fx->fl (bytes-ref rgbe (fx+ from channel))) unit) correction)))
      (store! 0 red)
      (store! 1 green)
      (store! 2 blue)))
  pixels)
