namespace ErrorMatching.Hmi;

/// <summary>Where features and their points are counted.</summary>
public sealed partial class PointsView : SetupView
{
    /// <summary>The view.</summary>
    public PointsView() => InitializeComponent();
}
