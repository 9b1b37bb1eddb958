namespace ErrorMatching.Freeform;

/// <summary>The same error everywhere: what a modified tool radius compensates.</summary>
/// <param name="errorMm">The error in millimetres, positive out of the material.</param>
/// <param name="standardUncertaintyMm">Its standard uncertainty.</param>
public sealed class ConstantField(double errorMm, double standardUncertaintyMm) : ErrorField
{
    /// <inheritdoc/>
    public override double At(double u, double v) => errorMm;

    /// <inheritdoc/>
    public override double StandardUncertaintyAt(double u, double v) => standardUncertaintyMm;
}
