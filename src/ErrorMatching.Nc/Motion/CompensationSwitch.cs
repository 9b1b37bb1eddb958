namespace ErrorMatching.Nc;

/// <summary>A word that concerns cutter compensation: it switches it, selects the tool's radius, or must not be there while it is
/// on.</summary>
/// <param name="Block">Its block.</param>
/// <param name="Joint">The joint of the path at which it takes effect: it applies to this motion and later ones.</param>
/// <param name="Meaning">What it does; <see cref="NcMeaning.Unknown"/> for a word at which the control stops,
/// <see cref="NcMeaning.Harmless"/> for a D word of its own while compensation is on.</param>
/// <param name="Word">The word as a setter would spell it: <c>G41</c>, <c>M6</c>, <c>D2</c>.</param>
/// <param name="Offset">Value of the D word in force; null if there is none, NaN if only the machine knows it.</param>
/// <param name="Unit">Millimeters per unit of a diameter given as D.</param>
internal readonly record struct CompensationSwitch(int Block, int Joint, NcMeaning Meaning, string Word, double? Offset, double Unit);
