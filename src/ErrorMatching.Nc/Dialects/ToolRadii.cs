namespace ErrorMatching.Nc;

/// <summary>The radii that a control uses for cutter compensation, as far as somebody stated them.</summary>
public sealed class ToolRadii
{
    private ToolRadii(double? radius, IReadOnlyDictionary<int, double> byNumber) => (Otherwise, ByNumber) = (radius, byNumber);

    /// <summary>The radius for all numbers that have none of their own, and without D, mm; null if it is not stated.</summary>
    public double? Otherwise { get; }

    /// <summary>Radii in mm by the number that D names.</summary>
    public IReadOnlyDictionary<int, double> ByNumber { get; }

    /// <summary>True if some radius is stated.</summary>
    public bool AreStated => Otherwise is not null || ByNumber.Count > 0;

    /// <summary>Nothing is stated: only diameters that the program itself gives are known.</summary>
    public static ToolRadii None { get; } = new(null, new Dictionary<int, double>());

    /// <summary>One tool for the whole program.</summary>
    /// <param name="radius">Its radius, mm, as the control has it; negative: on the other side.</param>
    public static ToolRadii Of(double radius) => new(radius, new Dictionary<int, double>());

    /// <summary>The radii in the control's table.</summary>
    /// <param name="byNumber">Radius in mm by the number that D names.</param>
    /// <param name="otherwise">Radius for all other numbers and without D, mm; null if it is not stated.</param>
    public static ToolRadii OfTable(IReadOnlyDictionary<int, double> byNumber, double? otherwise) => new(otherwise, byNumber);

    /// <summary>The radius for a D word, mm; null if nobody stated it.</summary>
    /// <param name="number">Value of the word; null if there is none, NaN if only the machine knows it.</param>
    public double? For(double? number) =>
        number is { } d && d == Math.Floor(d) && Math.Abs(d) < int.MaxValue && ByNumber.TryGetValue((int)d, out var radius)
            ? radius
            : Otherwise;
}
