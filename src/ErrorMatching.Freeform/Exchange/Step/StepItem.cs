namespace ErrorMatching.Freeform;

/// <summary>A surface of a STEP file: a face or a bare surface.</summary>
/// <param name="Instance">Its instance.</param>
/// <param name="MillimetersPerUnit">Length unit of the file in millimeters.</param>
internal readonly record struct StepItem(StepInstance Instance, double MillimetersPerUnit)
{
    /// <summary>True for a face of the outer shell of a solid, whose normal points out of the material.</summary>
    public bool IsOfSolid { get; init; }
}
