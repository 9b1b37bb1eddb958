namespace ErrorMatching.Freeform;

/// <summary>The nominal surface of a job.</summary>
/// <param name="File">IGES (.igs, .iges), STEP (.stp, .step) or a grid of points (.csv), relative to the job.</param>
/// <param name="Entity">Name or number, from 1, of the surface if the file has several; null if it has one.</param>
/// <param name="OutsideIsUp">True if the material is below the surface, so that the normal points to +z; false for -z.</param>
public sealed record JobSurface(string File, string? Entity, bool OutsideIsUp);
