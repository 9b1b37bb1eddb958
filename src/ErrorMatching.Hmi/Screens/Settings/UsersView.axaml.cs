using Avalonia.Controls;

namespace ErrorMatching.Hmi;

/// <summary>User management.</summary>
public sealed partial class UsersView : UserControl
{
    public UsersView() => InitializeComponent();
}
