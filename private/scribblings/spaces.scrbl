#lang scribble/manual
@; A vertex on its way from the shape it belongs to to a pixel, with numbers computed as the page is made.
@(require scribble/example (for-label racket/base racket/math raytrace))

@(define spaces (make-base-eval #:lang 'racket/base '(require raytrace)))

@title[#:tag "spaces"]{A vertex through the spaces}

Rasterization asks of every corner of every triangle where in the picture it is seen. It finds out by
taking the corner from one space to the next: the space the shape was made in, the world, the space
of the eye, device coordinates, pixels. Each step but one is a matrix. This page takes one vertex
all the way; every number on it was computed when the page was made.

@section[#:tag "spaces-model"]{From the model to the world}

The vertex is a corner of a box of side 2 around the origin of its own space. An @racket[Instance]
says where the box is in the world: turned by 90 degrees about the y axis, and moved.

@examples[#:eval spaces #:label #f
(define vertex (Float3 1 1 1))
(define model
  (Transform-compose (Transform-translate 3 0 -2)
                     (Transform-rotate (Float3 0 1 0) #:degrees 90)))
(Transform-matrix-rows model)
(define in-world (Transform-point model vertex))
in-world
]

These are the first three rows of the 4 × 4 matrix; the last is always 0 0 0 1. The three columns on
the left say where the axes of the model point in the world, and the column on the right where its
origin is.

@section[#:tag "spaces-view"]{From the world to the eye}

The camera stands at (0, 2, 8) and looks at (1, 1, 0). In the space of the eye it is the camera that
stands at the origin, with x to the right, y up, and its line of sight along −z.

@examples[#:eval spaces #:label #f
(define camera
  (Camera-look-at (Float3 0 2 8) (Float3 1 1 0) #:vertical-field-of-view-degrees 45))
(define view (Camera-view camera))
(define in-eye-space (Transform-point view in-world))
in-eye-space
(Transform-point view (Float3 0 2 8))
(Transform-point view (Float3 1 1 0))
]

The eye is at the origin, and the point that the camera looks at is straight ahead, on the negative z
axis, as far away as it is in the world: a view matrix turns and moves, and leaves distances as they
are.

@section[#:tag "spaces-projection"]{From the eye to device coordinates}

The projection matrix makes a cube of what can be seen, a pyramid without its tip between the
distances @racket[#:near] and @racket[#:far]. Its last row is not 0 0 0 1 but 0 0 −1 0: the fourth
coordinate of the product is the distance along the line of sight, by which the others are divided.
This division is what makes far things small.

@examples[#:eval spaces #:label #f
(define frustum (Camera-frustum camera #:near 1 #:far 100 #:width 640 #:height 360))
(for-each displayln (Projection-matrix-rows frustum))
(define on-device (Projection-point frustum in-eye-space))
on-device
]

Device coordinates go from −1 to 1 on all axes, from left to right, from bottom to top, and from near
to far. Depth is not linear: half of the cube's depth is spent on the first few units before the
camera. It has to be so, for only the reciprocal of the distance is linear over the picture.

@examples[#:eval spaces #:label #f
(for ([distance '(1 2 10 50 100)])
  (printf "~a: ~a\n" distance
          (Float3-z (Projection-point frustum (Float3 0 0 (- distance))))))
]

The planes between which something is seen come out of the rows of the same matrix. The vertex is
inside all six, so it needs no clipping; these are its distances from left, right, bottom, top,
near and far:

@examples[#:eval spaces #:label #f
(for/list ([plane (Projection-clip-planes frustum)])
  (+ (* (car plane) (Float3-x in-eye-space))
     (* (cadr plane) (Float3-y in-eye-space))
     (* (caddr plane) (Float3-z in-eye-space))
     (cadddr plane)))
]

@section[#:tag "spaces-viewport"]{From device coordinates to pixels}

The viewport matrix stretches the cube over the picture. Rows of pixels are counted from the top, so
y changes its sign; depth goes from 0 to 1.

@examples[#:eval spaces #:label #f
(define viewport (Transform-viewport 640 360))
(Transform-matrix-rows viewport)
(define in-pixels (Transform-point viewport on-device))
in-pixels
]

@section[#:tag "spaces-back"]{And back}

@racket[Camera-project] takes all the steps from the world on at once. Its third number is not the
depth of the cube but the distance along the ray, which is what the integrator @racket['depth] shows.
@racket[Camera-unproject] goes the other way.

@examples[#:eval spaces #:label #f
(define seen (Camera-project camera in-world #:width 640 #:height 360))
seen
(Camera-unproject camera seen #:width 640 #:height 360)
]

The ray that the ray tracer casts through this very place meets the vertex after this very distance, so
both ways of making a picture put every vertex at the same place. The ray is
cast by the camera as a picture of that shape has it, 16 by 9, which this camera is made for:

@examples[#:eval spaces #:label #f
(define ray (Camera-ray camera (/ (Float3-x seen) 640) (/ (Float3-y seen) 360)))
(Ray-point-at ray (Float3-z seen))
(Float3-length (Float3-subtract (Ray-point-at ray (Float3-z seen)) in-world))
]

@section[#:tag "spaces-picture"]{The picture}

What is left is to fill the triangles between the vertices, nearest on top, and to shade them: @racket[preview]
does it at once, @racket[render] with the light.

@examples[#:eval spaces #:label #f
(define world
  (World (list (Instance (Box (Float3 -1 -1 -1) (Float3 1 1 1) (Float3 0.9 0.5 0.2)) model)
               (Sphere (Float3 0 0 0) 1 (Float3 0.3 0.5 0.8)))
         (DistantLight (Float3 1 3 2) (Float3 0.8 0.8 0.8))
         (Float3 0.7 0.8 0.9)
         #:ambient-color (Float3 0.25 0.25 0.3)))
(preview world camera #:width 320 #:height 180)
(preview world camera #:width 320 #:height 180 #:shading 'wireframe)
]
