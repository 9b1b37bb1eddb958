using System.Globalization;

namespace ErrorMatching.Nc;

/// <summary>Values of variables that only the machine knows, as somebody stated them: <c>#100</c> is 1. A result holds for them
/// only.</summary>
public sealed class AssumedValues
{
    private readonly SortedDictionary<string, double> _values = new(StringComparer.Ordinal);

    private AssumedValues()
    {
    }

    /// <summary>Nothing is stated.</summary>
    public static AssumedValues None { get; } = new();

    /// <summary>Number of stated values.</summary>
    public int Count => _values.Count;

    /// <summary>The values by the names of their variables, in the order of the names.</summary>
    public IReadOnlyDictionary<string, double> Values => _values;

    /// <summary>Values by names as a program writes them, without regard to case and spaces.</summary>
    /// <param name="values">The names, each with its value; a later one replaces an earlier one.</param>
    /// <exception cref="ArgumentException">A name is empty, or a value is not finite.</exception>
    public static AssumedValues Of(IEnumerable<KeyValuePair<string, double>> values)
    {
        ArgumentNullException.ThrowIfNull(values);
        var assumed = new AssumedValues();
        foreach (var (name, value) in values)
        {
            if (!IsName(name) || !double.IsFinite(value))
            {
                throw new ArgumentException(FormattableString.Invariant($"{name}={value} is no value of a variable."), nameof(values));
            }

            assumed._values[NameOf(name)] = value;
        }

        return assumed;
    }

    /// <summary>Reads <c>#100=1</c>; null if it is something else.</summary>
    /// <param name="text">The name of a variable, an equals sign and a number.</param>
    public static KeyValuePair<string, double>? Read(string text)
    {
        ArgumentNullException.ThrowIfNull(text);
        const NumberStyles Number = NumberStyles.AllowLeadingSign | NumberStyles.AllowDecimalPoint;
        var equals = text.LastIndexOf('=');
        return equals > 0 && IsName(text[..equals])
            && double.TryParse(text.AsSpan(equals + 1).Trim(), Number, CultureInfo.InvariantCulture, out var value)
            && double.IsFinite(value)
            ? new(NameOf(text[..equals]), value)
            : null;
    }

    /// <summary>True for the name of a variable: <c>#100</c>, <c>#&lt;_depth&gt;</c>, <c>R5</c>, <c>$A_IN[1]</c>, <c>VC1</c>,
    /// <c>Q5</c>.</summary>
    /// <param name="name">The name.</param>
    public static bool IsName(string name)
    {
        ArgumentNullException.ThrowIfNull(name);
        var plain = NameOf(name);
        return plain.Length is > 1 and <= 64 && (plain[0] is '#' or '$' or '_' || char.IsAsciiLetter(plain[0]))
            && plain.All(c => char.IsAsciiLetterOrDigit(c) || c is '#' or '$' or '_' or '<' or '>' or '[' or ']' or ',' or ':' or '.');
    }

    /// <summary>These values, and those of others instead of and in addition to them.</summary>
    /// <param name="others">The others.</param>
    public AssumedValues With(AssumedValues others)
    {
        ArgumentNullException.ThrowIfNull(others);
        return others.Count == 0 ? this : Of(_values.Concat(others._values));
    }

    /// <summary>The value of a variable; null if none is stated.</summary>
    internal double? Of(string name) => _values.TryGetValue(name, out var value) ? value : null;

    /// <summary>The values as a sentence shows them.</summary>
    internal string Listed(IEnumerable<string> names) =>
        string.Join(", ", names.Select(n => $"{n} = {_values[n].ToString("R", CultureInfo.InvariantCulture)}"));

    private static string NameOf(string name) => name.Replace(" ", "", StringComparison.Ordinal).ToUpperInvariant();
}
