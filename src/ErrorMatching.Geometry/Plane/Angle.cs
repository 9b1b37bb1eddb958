using System.Globalization;

namespace ErrorMatching.Geometry;

/// <summary>An angle, positive counterclockwise. Stored in radians; every public interface of the system uses degrees.</summary>
/// <remarks>An angle keeps full turns: 370 degrees differs from 10 degrees until <see cref="Normalized"/>.</remarks>
public readonly record struct Angle : IComparable<Angle>
{
    private Angle(double radians) => Radians = radians;

    /// <summary>The angle in radians.</summary>
    public double Radians { get; }

    /// <summary>The angle in degrees.</summary>
    public double Degrees => Radians * (180 / Math.PI);

    /// <summary>The equivalent angle in (-180, 180] degrees.</summary>
    public Angle Normalized
    {
        get
        {
            var r = Math.IEEERemainder(Radians, 2 * Math.PI);
            return new(r <= -Math.PI ? r + (2 * Math.PI) : r);
        }
    }

    /// <summary>An angle given in radians.</summary>
    public static Angle FromRadians(double radians) => new(radians);

    /// <summary>An angle given in degrees.</summary>
    public static Angle FromDegrees(double degrees) => new(degrees * (Math.PI / 180));

    /// <summary>The unsigned angle between two directions, 0 to 180 degrees (equation 1 of Wang 2021, with the arc tangent to keep digits
    /// near 0 and 180).</summary>
    public static Angle Between(Vector2 a, Vector2 b) => new(Elementary.Atan2(Math.Abs(a.Cross(b)), a.Dot(b)));

    /// <summary>The angle in degrees as culture-independent text.</summary>
    public override string ToString() => string.Create(CultureInfo.InvariantCulture, $"{Degrees} deg");

    /// <inheritdoc/>
    public int CompareTo(Angle other) => Radians.CompareTo(other.Radians);

    /// <summary>The sum of two angles.</summary>
    public static Angle operator +(Angle a, Angle b) => new(a.Radians + b.Radians);

    /// <summary>The difference of two angles.</summary>
    public static Angle operator -(Angle a, Angle b) => new(a.Radians - b.Radians);

    /// <summary>The negated angle.</summary>
    public static Angle operator -(Angle a) => new(-a.Radians);

    /// <summary>A multiple of an angle.</summary>
    public static Angle operator *(Angle a, double factor) => new(a.Radians * factor);

    /// <summary>True if the first is smaller.</summary>
    public static bool operator <(Angle a, Angle b) => a.Radians < b.Radians;

    /// <summary>True if the first is larger.</summary>
    public static bool operator >(Angle a, Angle b) => a.Radians > b.Radians;

    /// <summary>True if the first is smaller or equal.</summary>
    public static bool operator <=(Angle a, Angle b) => a.Radians <= b.Radians;

    /// <summary>True if the first is larger or equal.</summary>
    public static bool operator >=(Angle a, Angle b) => a.Radians >= b.Radians;
}
