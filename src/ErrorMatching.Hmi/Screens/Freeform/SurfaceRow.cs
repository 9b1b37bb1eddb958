namespace ErrorMatching.Hmi;

/// <summary>A measured surface in a list.</summary>
/// <param name="Id">Number of its correction.</param>
/// <param name="Title">Number and serial number or file.</param>
/// <param name="Job">What people call the workpiece.</param>
/// <param name="State">How far it has come.</param>
/// <param name="Profile">Its profile as measured.</param>
/// <param name="Severity">How much it asks for attention.</param>
public sealed record SurfaceRow(long Id, string Title, string Job, string State, string Profile, Severity Severity)
{
    /// <summary>Identifies the row.</summary>
    public string AutomationId => "surface-" + Shown.Id(Id);
}
