namespace ErrorMatching.Hmi;

/// <summary>A quantity of a feature, without and with compensation.</summary>
/// <param name="Feature">Its feature or comparison.</param>
/// <param name="Quantity">The compared quantity, with the points of a comparison.</param>
/// <param name="Wanted">The part's value; a dash for deviations, which are relative to the part.</param>
/// <param name="Before">The value of the counterpart without compensation. A deviation is the worst point's, counterpart - part.</param>
/// <param name="After">The value of the counterpart with compensation, likewise.</param>
/// <param name="Improvement">Reduction of the error in percent of the error before, or a text that it has grown and by how much.</param>
/// <param name="Unit">mm or degrees.</param>
/// <param name="IsWorse">True if the error has grown.</param>
internal sealed record ImprovementRow(
    string Feature, string Quantity, string Wanted, string Before, string After, string Improvement, string Unit, bool IsWorse);
