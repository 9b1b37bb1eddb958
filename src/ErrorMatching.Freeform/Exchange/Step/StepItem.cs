namespace ErrorMatching.Freeform;

/// <summary>A surface of a STEP file: a face or a bare surface.</summary>
/// <param name="Instance">Its instance.</param>
/// <param name="MillimetersPerUnit">Length unit of the file in millimeters.</param>
internal readonly record struct StepItem(StepInstance Instance, double MillimetersPerUnit);
