namespace ErrorMatching.Freeform;

/// <summary>A surface of a STEP file: a face, or a surface without one.</summary>
/// <param name="Instance">Its instance.</param>
/// <param name="MillimetersPerUnit">What its lengths are multiplied by.</param>
internal readonly record struct StepItem(StepInstance Instance, double MillimetersPerUnit);
