namespace ErrorMatching.Nc;

/// <summary>A word that concerns cutter compensation: it switches it, selects the tool's radius, leads to a contour or away from it, or
/// must not be there while it is on.</summary>
/// <param name="Block">Its block.</param>
/// <param name="Joint">The joint of the path at which it takes effect: it applies to this motion and later ones.</param>
/// <param name="Meaning">What it does; <see cref="NcMeaning.Unknown"/> for a word at which the control stops,
/// <see cref="NcMeaning.Harmless"/> for a D word of its own while compensation is on.</param>
/// <param name="Word">The word as a setter would spell it: <c>G41</c>, <c>M6</c>, <c>RL</c>.</param>
internal readonly record struct CompensationSwitch(int Block, int Joint, NcMeaning Meaning, string Word)
{
    /// <summary>Number of the tool's radius: the D word in force, or the tool that was called; null if there is none, NaN if only the
    /// machine knows it.</summary>
    public double? Offset { get; init; }

    /// <summary>Millimeters per unit of a diameter given as D.</summary>
    public double Unit { get; init; }

    /// <summary>The radius that the program itself defines for the tool, mm; null if it does not, NaN if only the machine knows
    /// it.</summary>
    public double? Radius { get; init; }

    /// <summary>What the tool's call adds to its radius, mm; NaN if only the machine knows it.</summary>
    public double Oversize { get; init; }

    /// <summary>How far a block that leads to a contour or away from it goes straight, mm; NaN if it does not say.</summary>
    public double Length { get; init; }
}
