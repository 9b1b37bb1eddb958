namespace ErrorMatching.Nc;

/// <summary>A word that concerns cutter compensation: it switches it, selects the tool's radius, leads to a contour or away from it, or
/// must not be there while it is on.</summary>
/// <param name="Block">Its block.</param>
/// <param name="Joint">The joint of the path at which it takes effect: it applies to this motion and later ones.</param>
/// <param name="Kind">What kind of word it is.</param>
/// <param name="Meaning">What a switch does; for another kind of word, <see cref="NcMeaning.Unknown"/>.</param>
/// <param name="Word">The word as a setter would spell it: <c>G41</c>, <c>M6</c>, <c>RL</c>.</param>
internal readonly record struct CompensationSwitch(int Block, int Joint, SwitchKind Kind, NcMeaning Meaning, string Word)
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

/// <summary>A kind of word that concerns cutter compensation.</summary>
internal enum SwitchKind : byte
{
    /// <summary>It switches compensation, or says how the tool's center is led.</summary>
    Switch,

    /// <summary>The control stops at it while compensation is on.</summary>
    Stop,

    /// <summary>It selects another radius while compensation is on.</summary>
    OtherRadius,
}
