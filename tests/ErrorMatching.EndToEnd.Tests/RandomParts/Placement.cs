namespace ErrorMatching.EndToEnd.Tests;

/// <summary>From the generator's frame to the program's: flipped where the material is to be right of the travel,
/// then turned and moved.</summary>
internal sealed record Placement(bool Flip, double Turn, Flat Move)
{
    public Flat Vector(Flat own)
    {
        var flipped = Flip ? new Flat(own.U, -own.V) : own;
        return (Flat.Toward(Turn) * flipped.U) + (Flat.Toward(Turn).Left * flipped.V);
    }

    public Flat Place(Flat own) => Vector(own) + Move;

    public PathMove Place(PathMove own) =>
        new(Place(own.To), own.Center is { } center ? Place(center) : null, Flip ? -own.Sweep : own.Sweep);
}
