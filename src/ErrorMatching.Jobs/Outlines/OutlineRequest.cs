namespace ErrorMatching.Jobs;

/// <summary>A mating job that is wanted from a drawing and a program.</summary>
/// <param name="Job">The job to write.</param>
/// <param name="Drawing">The drawing.</param>
/// <param name="Program">The counterpart's program.</param>
/// <param name="Dialect">The control that the program is written for: a built-in dialect, or a shop's dialect file.</param>
public sealed record OutlineRequest(string Job, string Drawing, string Program, string Dialect)
{
    /// <summary>The layer with the outline that mates; null for the only one.</summary>
    public string? Layer { get; init; }

    /// <summary>Diameter of the tool, mm; null to find it by the distance of the outline from the path.</summary>
    public double? ToolDiameterMm { get; init; }

    /// <summary>Millimeters in the drawing's unit; null if the drawing says it.</summary>
    public double? UnitMm { get; init; }
}
