namespace ErrorMatching.EndToEnd.Tests;

/// <summary>A point or a vector of the referee in the working plane, mm.
/// The referee has its own types so that it shares nothing with what it judges.</summary>
internal readonly record struct Flat(double U, double V)
{
    public double Length => Math.Sqrt((U * U) + (V * V));

    /// <summary>The vector turned by 90 degrees counter-clockwise.</summary>
    public Flat Left => new(-V, U);

    /// <summary>Direction as an angle, radians.</summary>
    public double Heading => Math.Atan2(V, U);

    public static Flat Toward(double radians) => new(Math.Cos(radians), Math.Sin(radians));

    public static Flat operator +(Flat a, Flat b) => new(a.U + b.U, a.V + b.V);

    public static Flat operator -(Flat a, Flat b) => new(a.U - b.U, a.V - b.V);

    public static Flat operator -(Flat a) => new(-a.U, -a.V);

    public static Flat operator *(Flat a, double factor) => new(a.U * factor, a.V * factor);

    public double Dot(Flat other) => (U * other.U) + (V * other.V);

    public double Cross(Flat other) => (U * other.V) - (V * other.U);

    public Flat Unit() => this * (1 / Length);

    // The generated text would print Left, and Left's Left, without end.
    public override string ToString() => FormattableString.Invariant($"({U:R}, {V:R})");
}
