using System.Globalization;

namespace ErrorMatching.Freeform;

/// <summary>A parameter to write.</summary>
/// <param name="Text">Its text.</param>
internal sealed record IgesValue(string Text)
{
    /// <summary>An integer or a pointer.</summary>
    public static implicit operator IgesValue(int value) => new(value.ToString(CultureInfo.InvariantCulture));

    public static implicit operator IgesValue(double value) => new(ExchangeNumber.Of(value));

    /// <summary>A Hollerith string.</summary>
    public static IgesValue String(string value) => new(string.Create(CultureInfo.InvariantCulture, $"{value.Length}H{value}"));
}
