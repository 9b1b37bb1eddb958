namespace ErrorMatching.Mating;

/// <summary>A quantity of the counterpart that is compared with the part.</summary>
/// <param name="Word">Its word in reports and text keys.</param>
/// <param name="Words">Its display name.</param>
/// <param name="Unit">Its unit: mm or °.</param>
public sealed record VerifiedQuantity(string Word, string Words, string Unit)
{
    private const string Mm = "mm";

    /// <summary>The largest deviation along the normals, without sign, in millimeters; the wanted value is 0.</summary>
    public static VerifiedQuantity Deviation { get; } = new("deviation", "largest deviation along the normals", Mm);

    /// <summary>The largest deviation along the first axis of the plane, without sign, in millimeters; the wanted value is 0.</summary>
    public static VerifiedQuantity DeviationX { get; } = new("deviation-x", "largest deviation in X", Mm);

    /// <summary>The length of a line, in millimeters; the wanted value is the part's.</summary>
    public static VerifiedQuantity Length { get; } = new("length", "length", Mm);

    /// <summary>The angle inside a corner, in degrees; the wanted value is the part's.</summary>
    public static VerifiedQuantity Angle { get; } = new("angle", "angle", "°");

    /// <summary>All quantities: first those of every feature and of comparisons, then those of the kinds of features.</summary>
    public static IReadOnlyList<VerifiedQuantity> All =>
        [.. new[] { Deviation, DeviationX, Angle }.Concat(FeatureKinds.All.SelectMany(k => k.Verified)).Distinct()];

    /// <summary>True for a largest deviation, whose wanted value is 0.</summary>
    public bool IsDeviation => this == Deviation || this == DeviationX;

    /// <summary>Finds a quantity by its word.</summary>
    /// <exception cref="ArgumentException">No quantity has the word.</exception>
    public static VerifiedQuantity Of(string word) =>
        All.FirstOrDefault(q => q.Word == word)
            ?? throw new ArgumentException(
                $"Found the quantity \"{word}\"; expected one of {string.Join(", ", All.Select(q => q.Word))}.", nameof(word));

    /// <summary>The word.</summary>
    public override string ToString() => Word;
}
