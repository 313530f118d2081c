// What a ball of haze hands from its quad's vertices to fragments. VARYING is `out` or `in`.
VARYING HazeVaryings {
    flat vec4 centre_radius;  ///< camera-relative world, m
    flat uint material;       ///< row of the material buffer
    flat float opacity;       ///< [0, 1]
} ball;
