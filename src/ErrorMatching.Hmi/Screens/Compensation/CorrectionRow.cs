namespace ErrorMatching.Hmi;

/// <summary>A correction in a list.</summary>
/// <param name="Id">Its number.</param>
/// <param name="Title">Number and serial number or file.</param>
/// <param name="Job">What people call the workpiece.</param>
/// <param name="State">How far it has come.</param>
/// <param name="Largest">Its largest displacement; empty before it is computed.</param>
/// <param name="Severity">How much it asks for attention.</param>
/// <param name="IsOfChangedJob">True if it was made with its job as it was before somebody changed that.</param>
public sealed record CorrectionRow(long Id, string Title, string Job, string State, string Largest, Severity Severity, bool IsOfChangedJob)
{
    /// <summary>Identifies the row.</summary>
    public string AutomationId => "correction-" + Shown.Id(Id);
}
