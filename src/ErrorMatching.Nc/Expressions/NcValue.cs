using System.Globalization;

namespace ErrorMatching.Nc;

/// <summary>A value computed by a program: a finite number, a text, vacant, or known only to the machine.</summary>
/// <param name="Kind">Its kind.</param>
/// <param name="Number">The number; 0 for other kinds.</param>
/// <param name="Text">The text; null for other kinds.</param>
internal readonly record struct NcValue(NcValueKind Kind, double Number, string? Text)
{
    public static NcValue Vacant => default;

    public static NcValue Unknown => new(NcValueKind.Unknown, 0, null);

    public static NcValue Zero => new(NcValueKind.Number, 0, null);

    public bool IsNumber => Kind == NcValueKind.Number;

    public bool IsUnknown => Kind == NcValueKind.Unknown;

    public bool IsVacant => Kind == NcValueKind.Vacant;

    public static NcValue Of(double number) => new(NcValueKind.Number, number, null);

    public static NcValue Of(bool truth) => Of(truth ? 1 : 0);

    public static NcValue Of(string text) => new(NcValueKind.Text, 0, text);

    /// <summary>True if both are the same. Spelled out, because the generic comparison that the compiler writes would be compiled at each
    /// start.</summary>
    public bool Equals(NcValue other) =>
        Kind == other.Kind && Number.Equals(other.Number) && string.Equals(Text, other.Text, StringComparison.Ordinal);

    public override int GetHashCode() => HashCode.Combine((int)Kind, Number, Text);

    public override string ToString() => Kind switch
    {
        NcValueKind.Number => Number.ToString("R", CultureInfo.InvariantCulture),
        NcValueKind.Text => "\"" + Text + "\"",
        NcValueKind.Unknown => "unknown",
        _ => "vacant",
    };
}

/// <summary>Kind of a value computed by a program.</summary>
internal enum NcValueKind : byte
{
    /// <summary>Never assigned: Fanuc's null. A word with a vacant value counts as not written.</summary>
    Vacant,

    /// <summary>A number; true is 1 and false is 0.</summary>
    Number,

    /// <summary>Only the machine knows it, or it was computed from such a value.</summary>
    Unknown,

    /// <summary>Text (Siemens).</summary>
    Text,
}
