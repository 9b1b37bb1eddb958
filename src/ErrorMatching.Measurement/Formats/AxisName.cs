namespace ErrorMatching.Measurement;

/// <summary>Names of coordinates: the point's name and the axis, <c>P1.X</c>, <c>P1_X</c>, <c>P1 X</c>, <c>P1(X)</c>.</summary>
internal static class AxisName
{
    private const string Separators = "._- :/";

    /// <summary>Splits a name; null if it does not end with an axis.</summary>
    public static (string Label, char Axis)? Split(string name)
    {
        name = name.Trim();
        if (name.Length > 2 && ((name[^1] == ')' && name[^3] == '(') || (name[^1] == ']' && name[^3] == '[')))
        {
            return Of(name[..^3], name[^2]);
        }

        return name.Length > 2 && Separators.Contains(name[^2], StringComparison.Ordinal) ? Of(name[..^2], name[^1]) : null;
    }

    private static (string Label, char Axis)? Of(string label, char axis)
    {
        var letter = char.ToUpperInvariant(axis);
        return letter is 'X' or 'Y' or 'Z' && label.Trim() is { Length: > 0 } trimmed ? (trimmed, letter) : null;
    }
}
