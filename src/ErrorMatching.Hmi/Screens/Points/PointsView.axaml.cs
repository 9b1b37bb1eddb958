namespace ErrorMatching.Hmi;

/// <summary>The screen to enter features and their numbers of points.</summary>
public sealed partial class PointsView : SetupView
{
    public PointsView() => InitializeComponent();
}
