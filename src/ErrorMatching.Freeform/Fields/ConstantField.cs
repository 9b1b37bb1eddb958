namespace ErrorMatching.Freeform;

/// <summary>The same error everywhere, as a modified tool radius compensates it.</summary>
/// <param name="errorMm">The error in millimeters, positive out of the material.</param>
/// <param name="standardUncertaintyMm">Its standard uncertainty.</param>
public sealed class ConstantField(double errorMm, double standardUncertaintyMm) : ErrorField
{
    /// <inheritdoc/>
    public override double At(double u, double v) => errorMm;

    /// <inheritdoc/>
    public override double StandardUncertaintyAt(double u, double v) => standardUncertaintyMm;
}
