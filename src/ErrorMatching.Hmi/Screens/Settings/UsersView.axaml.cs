using Avalonia.Controls;

namespace ErrorMatching.Hmi;

/// <summary>Where users are managed.</summary>
public sealed partial class UsersView : UserControl
{
    /// <summary>The view.</summary>
    public UsersView() => InitializeComponent();
}
