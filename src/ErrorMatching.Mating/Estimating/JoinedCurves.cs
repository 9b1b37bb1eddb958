namespace ErrorMatching.Mating;

/// <summary>Curves that follow one another smoothly and deviate as one, whatever feature each belongs to: what the points of one say
/// reaches across the joint. Lengths are those of the first, and go on through the others.</summary>
/// <param name="Curves">The curves in the order of cutting, at least two.</param>
internal sealed record JoinedCurves(IReadOnlyList<BoundaryElement> Curves) : Stretch(ElementForm.Free)
{
    /// <inheritdoc/>
    public override double FromMm => Curves[0].FromMm;

    /// <inheritdoc/>
    public override double ToMm => OffsetOf(Curves[^1]) + Curves[^1].ToMm;

    /// <summary>What is added to a length along one of the curves.</summary>
    public double OffsetOf(BoundaryElement curve)
    {
        var at = Curves[0].FromMm;
        foreach (var other in Curves)
        {
            if (ReferenceEquals(other, curve))
            {
                return at - curve.FromMm;
            }

            at += other.ToMm - other.FromMm;
        }

        throw new ArgumentException("The curve is none of them.", nameof(curve));
    }
}
