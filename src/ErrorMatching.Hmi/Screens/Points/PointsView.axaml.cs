namespace ErrorMatching.Hmi;

/// <summary>The screen to enter features and their numbers of points.</summary>
internal sealed partial class PointsView : SetupView
{
    public PointsView() => InitializeComponent();
}
