namespace ErrorMatching.Mating;

/// <summary>What of the counterpart is compared with the part.</summary>
/// <param name="Word">Its word in reports and keys of texts.</param>
/// <param name="Words">What people call it.</param>
/// <param name="Unit">Its unit: mm or °.</param>
public sealed record VerifiedQuantity(string Word, string Words, string Unit)
{
    private const string Mm = "mm";

    /// <summary>The largest deviation along the normals, without sign, in millimetres; wanted is none.</summary>
    public static VerifiedQuantity Deviation { get; } = new("deviation", "largest deviation along the normals", Mm);

    /// <summary>The largest deviation along the first axis of the plane, without sign, in millimetres; wanted is none.</summary>
    public static VerifiedQuantity DeviationX { get; } = new("deviation-x", "largest deviation in X", Mm);

    /// <summary>The length of a line, in millimetres; wanted is the part's.</summary>
    public static VerifiedQuantity Length { get; } = new("length", "length", Mm);

    /// <summary>The angle inside a corner, in degrees; wanted is the part's.</summary>
    public static VerifiedQuantity Angle { get; } = new("angle", "angle", "°");

    /// <summary>All of them, those of the kinds of features behind those of every feature and of comparisons.</summary>
    public static IReadOnlyList<VerifiedQuantity> All =>
        [.. new[] { Deviation, DeviationX, Angle }.Concat(FeatureKinds.All.SelectMany(k => k.Verified)).Distinct()];

    /// <summary>True for the largest of some deviations, of which none is wanted.</summary>
    public bool IsDeviation => this == Deviation || this == DeviationX;

    /// <summary>The quantity of a word.</summary>
    /// <exception cref="ArgumentException">None has the word.</exception>
    public static VerifiedQuantity Of(string word) =>
        All.FirstOrDefault(q => q.Word == word)
            ?? throw new ArgumentException(
                $"Found the quantity \"{word}\"; expected one of {string.Join(", ", All.Select(q => q.Word))}.", nameof(word));

    /// <summary>The word.</summary>
    public override string ToString() => Word;
}
