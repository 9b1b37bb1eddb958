namespace ErrorMatching.EndToEnd.Tests;

/// <summary>A place or a direction in space, in millimetres. The referee has its own,
/// so that it shares no code with what it judges.</summary>
internal readonly record struct Place(double X, double Y, double Z)
{
    public double Length => Math.Sqrt(Dot(this));

    public static Place operator +(Place a, Place b) => new(a.X + b.X, a.Y + b.Y, a.Z + b.Z);

    public static Place operator -(Place a, Place b) => new(a.X - b.X, a.Y - b.Y, a.Z - b.Z);

    public static Place operator *(Place a, double f) => new(a.X * f, a.Y * f, a.Z * f);

    public double Dot(Place b) => (X * b.X) + (Y * b.Y) + (Z * b.Z);

    public Place Cross(Place b) => new((Y * b.Z) - (Z * b.Y), (Z * b.X) - (X * b.Z), (X * b.Y) - (Y * b.X));

    public Place Unit() => this * (1 / Length);
}
