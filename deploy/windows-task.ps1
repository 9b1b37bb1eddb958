# Starts a cell with Windows, as a task under an account of its own. Run it once as administrator; docs/install-a-cell.md says what comes before.
#   .\windows-task.ps1 -Program C:\errormatch\errormatch.exe -Config C:\errormatch\cell.json -Account .\errormatch
param(
    [Parameter(Mandatory)] [string] $Program,
    [Parameter(Mandatory)] [string] $Config,
    [Parameter(Mandatory)] [string] $Account,
    [string] $Name = 'ErrorMatching cell'
)
$ErrorActionPreference = 'Stop'
foreach ($file in $Program, $Config) {
    if (-not (Test-Path -LiteralPath $file -PathType Leaf)) { throw "There is no file $file." }
}

# The configuration must be right before anything starts by itself.
& $Program cell check $Config
if ($LASTEXITCODE -ne 0) { throw "errormatch cell check ended with $LASTEXITCODE. Put that right first." }

$action = New-ScheduledTaskAction -Execute $Program -Argument "cell run `"$Config`"" -WorkingDirectory (Split-Path -Parent $Config)
$trigger = New-ScheduledTaskTrigger -AtStartup
# No time limit, no stop on battery, started again one minute after it ended, for as long as it takes.
$settings = New-ScheduledTaskSettingsSet -ExecutionTimeLimit ([TimeSpan]::Zero) -RestartCount 999 -RestartInterval (New-TimeSpan -Minutes 1) `
    -Priority 4 -MultipleInstances IgnoreNew -AllowStartIfOnBatteries -DontStopIfGoingOnBatteries -StartWhenAvailable
$password = (Get-Credential -UserName $Account -Message 'The account that the cell runs under').GetNetworkCredential().Password
Register-ScheduledTask -TaskName $Name -Action $action -Trigger $trigger -Settings $settings -User $Account -Password $password -RunLevel Limited -Force | Out-Null
Start-ScheduledTask -TaskName $Name
Start-Sleep -Seconds 5
& $Program cell status $Config
