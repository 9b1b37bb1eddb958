using System.Globalization;

namespace ErrorMatching.Freeform;

/// <summary>A parameter as it is written.</summary>
/// <param name="Text">Its spelling.</param>
internal sealed record IgesValue(string Text)
{
    /// <summary>A whole number or a pointer.</summary>
    public static implicit operator IgesValue(int value) => new(value.ToString(CultureInfo.InvariantCulture));

    /// <summary>A real number.</summary>
    public static implicit operator IgesValue(double value) => new(ExchangeNumber.Of(value));

    /// <summary>A string in Hollerith form.</summary>
    public static IgesValue String(string value) => new(string.Create(CultureInfo.InvariantCulture, $"{value.Length}H{value}"));
}
