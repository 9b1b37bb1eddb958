namespace ErrorMatching.Hmi;

/// <summary>A correction in a list.</summary>
/// <param name="Id">Its number.</param>
/// <param name="Title">Number and serial number or file.</param>
/// <param name="Job">The workpiece's name.</param>
/// <param name="State">Its state.</param>
/// <param name="Largest">Its largest displacement; empty before it is computed.</param>
/// <param name="Severity">Its severity.</param>
/// <param name="IsOfChangedJob">True if its job was changed after it was computed.</param>
public sealed record ListedCorrection(
    long Id, string Title, string Job, string State, string Largest, Severity Severity, bool IsOfChangedJob)
{
    public string AutomationId => "correction-" + Shown.Id(Id);
}
