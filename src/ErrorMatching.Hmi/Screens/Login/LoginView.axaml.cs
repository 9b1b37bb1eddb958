using System.ComponentModel;
using Avalonia.Controls;
using Avalonia.Interactivity;

namespace ErrorMatching.Hmi;

internal sealed partial class LoginView : UserControl
{
    public LoginView() => InitializeComponent();

    /// <inheritdoc/>
    protected override void OnLoaded(RoutedEventArgs e)
    {
        base.OnLoaded(e);
        if (DataContext is LoginViewModel login)
        {
            Later.Focus(login.Name.Length == 0 ? NameBox : PasswordBox);
            login.PropertyChanged += OnLogin;
        }
    }

    /// <inheritdoc/>
    protected override void OnUnloaded(RoutedEventArgs e)
    {
        if (DataContext is LoginViewModel login)
        {
            login.PropertyChanged -= OnLogin;
        }

        base.OnUnloaded(e);
    }

    // After tapping a user, continue with the password; when typing a name, stay there.
    private void OnLogin(object? sender, PropertyChangedEventArgs e)
    {
        if (e.PropertyName is nameof(LoginViewModel.Chosen) && !NameBox.IsFocused && (sender as LoginViewModel)?.Chosen is not null)
        {
            PasswordBox.Focus();
        }
    }
}
